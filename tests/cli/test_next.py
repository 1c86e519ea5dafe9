"""`next`: a home when there is none, the right exercise, its files, the lesson once."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from tests.cli.conftest import Checker, Ros2course

LIGHT = "ros2_tutorial_workspace/src/lanterns/lanterns/light.py"


def test_on_a_bare_machine_it_makes_a_home_and_says_so(ros2course: Ros2course, home: Path) -> None:
    run = ros2course("next")
    assert run.code == 0
    assert f"Made a course home: {home}" in run.out
    assert (home / LIGHT).is_file()
    assert f"  + {LIGHT}" in run.out
    assert "Write `full()` in `light.py`." in run.out
    assert "  ros2course check" in run.out.split("Type next:")[1]


def test_the_home_is_made_where_told(
    ros2course: Ros2course, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert ros2course("--home", str(tmp_path / "a"), "next").code == 0
    assert (tmp_path / "a" / LIGHT).is_file()
    monkeypatch.setenv("ROS2COURSE_HOME", str(tmp_path / "b"))
    assert ros2course("next").code == 0
    assert (tmp_path / "b" / LIGHT).is_file()


def test_the_lesson_is_shown_once_or_when_asked(ros2course: Ros2course, home: Path) -> None:
    assert "brightness from 0 to 100" in ros2course("next").out
    assert "brightness from 0 to 100" not in ros2course("next").out
    assert "brightness from 0 to 100" in ros2course("next", "--lesson").out


@pytest.fixture
def read(small_course: Path) -> Callable[[int], None]:
    """Adds a chapter of that number to the course, whose text can be read and that has no exercise."""

    def add(number: int) -> None:
        folder = small_course / f"chapters/{number:02d}-read"
        folder.mkdir()
        (folder / "lesson.md").write_text(f"Text of chapter {number}.")
        yaml = f"chapter: {number}\ntitle: Reading\nsummary: Nothing to do.\nexercises: []\n"
        (folder / "lesson.yaml").write_text(yaml)

    return add


def test_chapters_without_exercises_are_read_in_passing(
    ros2course: Ros2course, home: Path, read: Callable[[int], None]
) -> None:
    for number in (2, 3, 5):
        read(number)
    told = ros2course("next").out
    assert told.index("Text of chapter 2") < told.index("Text of chapter 3") < told.index("brightness from")
    assert "Text of chapter 5" not in told
    assert "Text of chapter" not in ros2course("next").out
    for command in ("next", "show"):
        again = ros2course(command, "--lesson").out
        assert "Text of chapter 2" in again and "Text of chapter 3" in again


def test_one_that_is_read_later_is_not_taken_for_read(
    ros2course: Ros2course, home: Path, read: Callable[[int], None]
) -> None:
    ros2course("next")
    read(3)
    told = ros2course("next").out
    assert "Text of chapter 3" in told and "brightness from" not in told


def test_the_last_chapters_are_read_when_all_is_passed(
    ros2course: Ros2course, home: Path, read: Callable[[int], None], checker: Checker
) -> None:
    read(5)
    pass_all(ros2course, checker)
    told = ros2course("next").out
    assert told.index("Text of chapter 5") < told.index("You have passed every exercise")
    assert "Text of chapter 5" not in ros2course("next").out


def test_nothing_of_the_learner_is_overwritten(ros2course: Ros2course, home: Path) -> None:
    ros2course("next")
    (home / LIGHT).write_text("mine")
    run = ros2course("next")
    assert (home / LIGHT).read_text() == "mine"
    assert "New files" not in run.out


def test_it_stays_until_passed_and_then_goes_on(ros2course: Ros2course, home: Path, checker: Checker) -> None:
    ros2course("next")
    assert "04-light" in ros2course("next").out
    ros2course("check")
    run = ros2course("next")
    assert "== 04-dim: Dim it" in run.out


def test_going_to_an_exercise_names_what_it_stands_on(ros2course: Ros2course, home: Path) -> None:
    run = ros2course("next", "dim")
    assert "== 04-dim: Dim it" in run.out
    assert "It stands on what you make in 04-light, which is not passed yet." in run.out
    assert "== 04-dim: Dim it" in ros2course("next").out


def pass_all(ros2course: Ros2course, checker: Checker) -> None:
    from dataclasses import replace

    from tests.cli.conftest import PASSED

    for exercise in ("04-light", "04-dim"):
        ros2course("next", exercise)
        checker.answer = replace(PASSED, exercise=exercise)
        assert ros2course("check").code == 0


def test_at_the_end_it_congratulates(ros2course: Ros2course, home: Path, checker: Checker) -> None:
    pass_all(ros2course, checker)
    run = ros2course("next")
    assert run.code == 0
    assert "passed every exercise" in run.out


def test_skipped_exercises_come_back_at_the_end(ros2course: Ros2course, home: Path, checker: Checker) -> None:
    from dataclasses import replace

    from tests.cli.conftest import PASSED

    ros2course("next", "04-dim")
    checker.answer = replace(PASSED, exercise="04-dim")
    ros2course("check")
    assert "== 04-light" in ros2course("next").out


def test_progress_of_another_course_is_no_obstacle(ros2course: Ros2course, home: Path) -> None:
    from course.progress import Progress

    ros2course("init")
    with Progress.open(home / ".ros2course") as progress:
        progress.set_current("99-elsewhere")
    assert "== 04-light" in ros2course("next").out
