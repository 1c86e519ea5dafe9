"""The whole course on a pseudo-terminal, from `init` to the last exercise, solved one by one."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from course.content import Exercise, open_course
from course.grading import trial
from course.grading.trial_answers import SEED
from course.home import CourseHome

from .conftest import Type

pytestmark = pytest.mark.slow


def test_from_init_to_the_last_exercise(terminal: Type, course_home: Path) -> None:
    course = open_course()
    terminal("init")
    set_seed(CourseHome(course_home))
    for exercise in course.exercises():
        shown = terminal("next")
        assert f"== {exercise.id}: {exercise.title}" in shown, shown
        if exercise.local_only:
            solve_on_this_machine(exercise, course_home)
        trial.lay_solution(course, exercise, course_home)
        shown = terminal("check")
        assert "Passed: " in shown, f"{exercise.id}\n{shown}"
    count = len(course.exercises())
    assert f"{count} of {count} passed" in terminal("list")
    shown = terminal("next")
    for lesson in course.last_lessons():
        assert f"== Chapter {lesson.chapter.number}: {lesson.chapter.title}" in shown, shown
    assert "You have passed every exercise" in shown
    assert "== " not in terminal("next"), "there is nothing left to do, nor to read"


def set_seed(home: CourseHome) -> None:
    """That of the learner who does it all right."""
    marker = home.state / "home.json"
    marker.write_text(json.dumps({**json.loads(marker.read_text()), "seed": SEED}))
    assert home.seed() == SEED


def solve_on_this_machine(exercise: Exercise, home: Path) -> None:
    """Things that no tree of files can contain."""
    assert exercise.id == "02-venv"
    command = [sys.executable, "-m", "venv", "--without-pip", str(home / "ros2tutorial_venv")]
    subprocess.run(command, check=True, timeout=120)
