"""`env`, and the files that a learner's shell starts with."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from course.cli.shell import write_command, write_start_file
from course.errors import StorageError
from course.home import create_home

if TYPE_CHECKING:
    from tests.cli.conftest import Ros2course


@pytest.fixture(autouse=True)
def pretended_ros(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    script = tmp_path / "a ros" / "setup.bash"
    script.parent.mkdir()
    script.write_text("export ROS_DISTRO=pretended\n")
    monkeypatch.setattr("course.cli.shell.find_ros", lambda: None)
    monkeypatch.setattr("course.cli.shell.prepare", lambda ros: None)
    monkeypatch.setattr("course.cli.shell.setup_script", lambda ros: script)
    return script


def bash(script: str) -> str:
    done = subprocess.run(["bash", "-c", script], capture_output=True, text=True, check=True)
    return done.stdout


def test_what_env_prints_makes_a_shell_ready(ros2course: Ros2course, tmp_path: Path) -> None:
    home = tmp_path / "it's a home"
    ros2course("init", str(home))
    text = ros2course("env", "--home", str(home)).out
    said = bash(f"{text}\necho $ROS_DISTRO; echo $ROS2COURSE_HOME; ros2course --version")
    assert said.splitlines()[:2] == ["pretended", str(home)]
    assert said.splitlines()[2].startswith("ros2course ")
    assert "~/.bashrc" in text


def test_the_command_prefers_the_launcher(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    launcher = tmp_path / "a clone" / "ros2course"
    launcher.parent.mkdir()
    launcher.write_text('#!/bin/sh\necho "launched $ROS2COURSE_CALLED_AS $1"\n')
    launcher.chmod(0o755)
    monkeypatch.chdir(launcher.parent)
    monkeypatch.setenv("ROS2COURSE_LAUNCHER", "./ros2course")
    folder = write_command(create_home(tmp_path / "home"))
    assert bash(f"cd /; '{folder}/ros2course' hint") == "launched ros2course hint\n"


def test_the_command_never_calls_itself(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    home = create_home(tmp_path / "home")
    monkeypatch.delenv("ROS2COURSE_LAUNCHER", raising=False)
    file = write_command(home) / "ros2course"
    monkeypatch.setattr("sys.argv", [str(file), "shell"])
    write_command(home)
    assert str(file) not in file.read_text()


def test_a_home_that_cannot_be_written_is_said(tmp_path: Path, pretended_ros: Path) -> None:
    home = create_home(tmp_path / "home")
    (home.state / "shell").write_text("in the way")
    with pytest.raises(StorageError):
        write_start_file(home, pretended_ros)


def test_the_start_file_survives_a_strict_bashrc(tmp_path: Path, pretended_ros: Path) -> None:
    home = create_home(tmp_path / "home")
    (home.path / ".bashrc").write_text("set -eu\n")
    start = write_start_file(home, pretended_ros)
    assert "alive" in bash(f"HOME='{home.path}'; . '{start}'; echo alive")
    assert os.access(start.parent / "bin" / "ros2course", os.X_OK)
