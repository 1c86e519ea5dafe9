"""`hint`, `list`, `show`, `reset`, `solution`, `init`: one after the other."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

import pytest

from course.errors import MissingHere

if TYPE_CHECKING:
    from tests.cli.conftest import Ros2course

LIGHT = "ros2_tutorial_workspace/src/lanterns/lanterns/light.py"


@pytest.fixture
def begun(ros2course: Ros2course, home: Path) -> None:
    ros2course("next")


@pytest.mark.usefixtures("begun")
class TestReset:
    def test_what_was_there_goes_to_a_backup_that_is_named(self, ros2course: Ros2course, home: Path) -> None:
        (home / LIGHT).write_text("mine")
        run = ros2course("reset", "04-light")
        backup = Path(run.out.split("Your files are saved in ")[1].splitlines()[0])
        assert (backup / LIGHT).read_text() == "mine"
        assert (home / LIGHT).read_text() != "mine"
        assert f"  + {LIGHT}" in run.out

    def test_an_id_is_needed(self, ros2course: Ros2course) -> None:
        assert ros2course("reset").code == 2


@pytest.mark.usefixtures("begun")
class TestSolution:
    def test_hostile_files_do_nothing(self, ros2course: Ros2course, home: Path) -> None:
        (home / LIGHT).write_text("\x1b]0;owned\x07[bold]x[/bold]\n\x1b[2J" + "y" * 100_000)
        run = ros2course("solution", "--anyway")
        assert "\x1b" not in run.out and "owned" not in run.out
        assert "-[bold]x[/bold]" in run.out
        assert len(run.out) < 10_000


class TestInit:
    def test_where_told(self, ros2course: Ros2course, tmp_path: Path) -> None:
        run = ros2course("init", str(tmp_path / "there"))
        assert run.code == 0
        assert f"Created a course home: {tmp_path / 'there'}" in run.out
        assert "ros2course next" in run.out
        assert (tmp_path / "there/ros2_tutorial_workspace/src").is_dir()

    def test_it_tells_the_line_that_readies_a_terminal(self, ros2course: Ros2course) -> None:
        line = next(line for line in ros2course("init").out.splitlines() if "source " in line)
        command = ["bash", "-ec", f"{line}; ros2 pkg list"]
        run = subprocess.run(command, capture_output=True, text=True, check=True)
        assert "rclpy" in run.stdout.split()

    def test_a_machine_without_ros_gets_a_home_all_the_same(
        self, ros2course: Ros2course, home: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        def missing() -> NoReturn:
            raise MissingHere("no ROS 2", "install it")

        monkeypatch.setattr("course.cli.init.setup_line", missing)
        run = ros2course("init")
        assert (run.code, run.err, "source " in run.out) == (0, "", False)
        assert home.is_dir()

    def test_twice_changes_nothing(self, ros2course: Ros2course, home: Path) -> None:
        ros2course("init")
        (home / ".bashrc").write_text("mine")
        run = ros2course("init")
        assert run.code == 0
        assert "This already is a course home" in run.out
        assert (home / ".bashrc").read_text() == "mine"
