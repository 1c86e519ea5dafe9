"""docs/authoring.md and docs/first-exercise.md, done as they say: from nothing to a proven exercise."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.docs.walk import Command, File, steps

ROOT = Path(__file__).parents[2]
WALK = steps(ROOT / "docs/authoring.md")
SHORT_WALK = steps(ROOT / "docs/first-exercise.md")


def typed(line: str, folder: Path, programs: Path) -> tuple[int, str, Path]:
    """The exit code, all output, and the folder in which the shell is afterwards."""
    environment = {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}", "COLUMNS": "100"}
    environment.pop("ROS2COURSE_HOME", None)  # the document makes the home
    after = programs / "after"
    script = f"{line}\ncode=$?\npwd > {after}\nexit $code"
    done = subprocess.run(
        ["bash", "-c", script], cwd=folder, env=environment, capture_output=True, text=True, check=False
    )
    return done.returncode, done.stdout + done.stderr, Path(after.read_text().strip())


@pytest.fixture
def programs(tmp_path: Path) -> Path:
    """A folder with the command `ros2course` of this checkout."""
    folder = tmp_path / "programs"
    folder.mkdir()
    program = folder / "ros2course"
    program.write_text(f'#!/bin/sh\nPYTHONPATH="{ROOT}" exec "{sys.executable}" -m course "$@"\n')
    program.chmod(0o755)
    return folder


def test_the_document_is_read_as_a_walk() -> None:
    files = [step.name for step in WALK if isinstance(step, File)]
    commands = [step.line for step in WALK if isinstance(step, Command)]
    assert len(files) == 7 and "graders/ch01_power.py" in files
    assert "ros2course validate battery --course ." in commands
    assert [step.code for step in WALK if isinstance(step, Command) and "check" in step.line] == [1]


@pytest.mark.slow
@pytest.mark.parametrize("walk", [WALK, SHORT_WALK], ids=["authoring", "first-exercise"])
def test_every_command_and_every_file_of_it(
    walk: list[File | Command], tmp_path: Path, programs: Path
) -> None:
    folder = tmp_path / "author"
    folder.mkdir()
    for step in walk:
        if isinstance(step, File):
            assert (folder / step.name).is_file(), f"`new` did not make {step.name}"
            (folder / step.name).write_text(step.text, encoding="utf-8")
        else:
            code, said, folder = typed(step.line, folder, programs)
            assert code == step.code, f"{step.line}\n{said}"
    assert list((tmp_path / "author").glob("*-home/.ros2course/evidence/*.mcap"))
