"""`hint`, `list`, `show`, `reset`, `solution`, `init`: one after the other."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

import pytest

from course.cli import shell
from course.errors import MissingHere

if TYPE_CHECKING:
    from tests.cli.conftest import Checker, Ros2course

LIGHT = "ros2_tutorial_workspace/src/lanterns/lanterns/light.py"


@pytest.fixture
def begun(ros2course: Ros2course, home: Path) -> None:
    ros2course("next")


@pytest.mark.usefixtures("begun")
class TestHint:
    def test_each_call_goes_one_further_and_the_last_one_stays(self, ros2course: Ros2course) -> None:
        assert "Hint 1 of 3" in ros2course("hint").out
        assert "Hint 2 of 3" in ros2course("hint").out
        last = ros2course("hint")
        assert "Hint 3 of 3" in last.out
        assert "ros2course solution 04-light --anyway" in last.out
        assert "Hint 3 of 3" in ros2course("hint").out

    def test_again_shows_the_last_one(self, ros2course: Ros2course) -> None:
        assert "Hint 1 of 3" in ros2course("hint", "--again").out, "the first when there was none"
        assert "Hint 1 of 3" in ros2course("hint", "--again").out
        assert "Hint 2 of 3" in ros2course("hint").out

    def test_all_shows_and_remembers_all(self, ros2course: Ros2course) -> None:
        run = ros2course("hint", "--all")
        assert [f"Hint {number} of 3" in run.out for number in (1, 2, 3)] == [True] * 3
        assert "That was the last hint." in run.out
        assert "Hint 3 of 3" in ros2course("hint", "--again").out

    def test_of_another_exercise(self, ros2course: Ros2course) -> None:
        assert "Hint 1 of 3 for 04-dim" in ros2course("hint", "04-dim").out


@pytest.mark.usefixtures("begun")
class TestShow:
    def test_the_current_one(self, ros2course: Ros2course, home: Path) -> None:
        run = ros2course("show")
        assert "== 04-light: Light it (begun)" in run.out
        assert f"Your files, in {home}:" in run.out
        assert "brightness from 0" not in run.out

    def test_with_its_lesson_and_changing_nothing(self, ros2course: Ros2course) -> None:
        run = ros2course("show", "dim", "--lesson")
        assert "brightness from 0" in run.out and "== 04-dim: Dim it (new)" in run.out
        assert "04-light" in ros2course("show").out

    def test_a_pager_is_no_obstacle_off_a_terminal(self, ros2course: Ros2course) -> None:
        assert "Light it" in ros2course("show", "--pager").out


@pytest.mark.usefixtures("begun")
class TestList:
    def test_states_and_points(self, ros2course: Ros2course, checker: Checker) -> None:
        assert "> ..  04-light" in ros2course("list").out
        ros2course("check")
        lines = ros2course("list").out.splitlines()
        assert lines[0] == "4 Lanterns"
        assert lines[1].startswith("> ok  04-light  Light it") and lines[1].endswith("2 of 2")
        assert lines[2].startswith("      04-dim")
        assert "1 of 2 passed." in lines
        assert max(map(len, lines)) <= 80


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
    def test_not_before_a_pass_unless_told(self, ros2course: Ros2course, checker: Checker) -> None:
        refused = ros2course("solution")
        assert (refused.code, refused.out) == (2, "")
        assert "04-light is not passed yet" in refused.err and "--anyway" in refused.err
        assert "+    return 100" in ros2course("solution", "--anyway").out
        ros2course("check")
        assert "+    return 100" in ros2course("solution").out

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
        assert f"Made a course home: {tmp_path / 'there'}" in run.out
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

        monkeypatch.setattr(shell, "setup_line", missing)
        run = ros2course("init")
        assert (run.code, run.err, "source " in run.out) == (0, "", False)
        assert home.is_dir()

    def test_by_default_in_the_home(self, ros2course: Ros2course, home: Path) -> None:
        ros2course("init")
        assert home.is_dir()

    def test_twice_changes_nothing(self, ros2course: Ros2course, home: Path) -> None:
        ros2course("init")
        (home / ".bashrc").write_text("mine")
        run = ros2course("init")
        assert run.code == 0
        assert "This is a course home already" in run.out
        assert (home / ".bashrc").read_text() == "mine"
