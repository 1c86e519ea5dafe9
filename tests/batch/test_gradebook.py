"""The input of reports: read from the file of results, one submission after another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from datetime import datetime, timezone
from pathlib import Path

import pytest

from course.batch.class_page import cleaner, gradebook, graded_exercise
from course.batch.marks import Decisions
from course.batch.results import Results, keep_people
from course.content import Course, open_course
from course.model import replace
from course.model.gradebook import HandMark, Person
from course.report.gradebook.cleaning import Cleaner
from course.report.gradebook.sheets import sheets
from tests.batch.samples import FAILED, PASSED, QUIZ, graded, submissions

NOW = datetime(2026, 3, 2, tzinfo=timezone.utc)


@pytest.fixture
def results(tmp_path: Path) -> Iterator[Results]:
    with Results.open(tmp_path) as opened:
        opened.enter(submissions("cleo", "ada", "bao"))
        opened.record(graded("ada", FAILED), "1.0", None)
        opened.record(graded("cleo", PASSED), "1.0", None)
        yield opened


def test_everybody_is_in_it_in_the_order_of_the_class(results: Results, quiz_course: Course) -> None:
    book = gradebook(results, "Title", [quiz_course.exercise(QUIZ)], NOW, NOW)
    for _ in range(2):  # it can be iterated again
        assert [(one.person.id, one.results) for one in book.graded] == [
            ("cleo", (PASSED,)),
            ("ada", (FAILED,)),
            ("bao", ()),
        ]
    assert book.containment == "contained"
    assert {one.remarks for one in book.graded} == {("It is late.",)}


def test_points_that_can_be_had_are_those_of_questions_and_checks(quiz_course: Course) -> None:
    assert graded_exercise(quiz_course.exercise(QUIZ)).max_points == 6.0


@pytest.mark.parametrize(("name", "points"), [("18-publisher", 12), ("14-library", 7)])
def test_a_bonus_is_not_among_them(name: str, points: float) -> None:
    assert graded_exercise(open_course().exercise(name)).max_points == points


def test_places_of_this_machine_do_not_get_into_reports(tmp_path: Path) -> None:
    clean = cleaner(tmp_path / "out", tmp_path / "class")
    said = clean.prose(f"It is in {tmp_path}/out/x and {tmp_path}/class/ada.")
    assert str(tmp_path) not in said


def test_another_name_costs_a_point_unless_a_person_gave_the_points(
    results: Results, quiz_course: Course
) -> None:
    def points(*marks: HandMark) -> dict[str, float | None]:
        decisions = Decisions({"cleo": marks})
        book = gradebook(results, "Title", [quiz_course.exercise(QUIZ)], NOW, NOW, decisions)
        return {sheet.person.id: sheet.marks[0].points for sheet in sheets(book, Cleaner())}

    def named(exercises: list[str], held: Sequence[str] = ()) -> None:
        people = (Person(one, renamed=tuple(exercises)) for one in ("cleo", "bao"))
        keep_people(results, [*people, Person("ada"), Person("dev", graded_as="cleo")], held)

    results.record(graded("cleo", replace(PASSED, exercise=QUIZ)), "1.0", None)
    before = points()["cleo"] or 0
    assert before > 1
    named([QUIZ])
    assert points() == {"cleo": before - 1, "ada": points()["ada"], "bao": 0}
    assert points(HandMark(QUIZ, bonus=2))["cleo"] == before + 1
    assert points(HandMark(QUIZ, points=2.5))["cleo"] == 2.5
    named([], held=["cleo"])
    assert points()["cleo"] == before - 1
    named([])
    assert points()["cleo"] == before
