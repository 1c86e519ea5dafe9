"""`next`: a home when there is none, the right exercise, its files, the lesson once."""

from __future__ import annotations

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


def test_at_the_end_it_congratulates(ros2course: Ros2course, home: Path, checker: Checker) -> None:
    from dataclasses import replace

    from tests.cli.conftest import PASSED

    for exercise in ("04-light", "04-dim"):
        ros2course("next", exercise)
        checker.answer = replace(PASSED, exercise=exercise)
        assert ros2course("check").code == 0
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
