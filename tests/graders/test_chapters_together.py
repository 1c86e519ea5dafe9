"""One package that several chapters extend: earlier work stays, and still passes."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.content import Course
from course.grading import trial
from course.home import CourseHome, begin
from course.validate.claims import earns_all

from .conftest import Check

PACKAGE = "ros2_tutorial_workspace/src/python_package_with_a_node"


def test_chapter_12_goes_on_with_the_package_of_chapter_8(course: Course, home: Path) -> None:
    trial.lay_solution(course, course.exercise("08-template-node"), home)
    new = begin(CourseHome(home), course.exercise("12-print-forever"))
    assert [str(file.relative_to(home)) for file in new] == [
        f"{PACKAGE}/python_package_with_a_node/print_forever_node.py"
    ]


def test_chapter_12_brings_the_whole_package_to_those_without_chapter_8(course: Course, home: Path) -> None:
    begin(CourseHome(home), course.exercise("12-print-forever"))
    trial.lay_solution(course, course.exercise("08-template-node"), other := home / "other")
    made = {file.relative_to(other) for file in (other / PACKAGE).rglob("*") if file.is_file()}
    assert {str(file) for file in made if not (home / file).is_file()} == set()


@pytest.mark.slow
def test_chapter_8_still_passes_after_chapter_12(course: Course, home: Path, check: Check) -> None:
    for exercise in ("08-template-node", "12-print-forever"):
        trial.lay_solution(course, course.exercise(exercise), home)
    assert earns_all(check(course.exercise("08-template-node"), home)) == []
