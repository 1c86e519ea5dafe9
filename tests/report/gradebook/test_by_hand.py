"""Marks by people and the cost of lateness, in every format."""

from __future__ import annotations

import json

import jsonschema
import pytest

from course.model import replace
from course.model.gradebook import Delay, HandMark
from course.report.gradebook import class_files, github, gradescope, junit
from course.report.gradebook.letter import letter
from course.report.gradebook.sheets import Sheet, sheets
from tests.report.gradebook import samples

EXERCISE = "18-publisher"
LATE = Delay(samples.BEGAN, 86_400 * 2, 0.2, "2 days late")


def sheet(
    *by_hand: HandMark,
    late: Delay | None = None,
    graded: samples.GradedSubmission = samples.BAO,
) -> Sheet:
    return samples.sheet_of(replace(graded, by_hand=by_hand, lateness=late))


def test_bao_has_three_of_five() -> None:
    assert (sheet().points, sheet().raw_points, sheet().max_points) == (3, 3, 5)


@pytest.mark.parametrize(
    ("mark", "points"),
    [
        (HandMark(EXERCISE, bonus=1), 4),
        (HandMark(EXERCISE, bonus=-9), 0),
        (HandMark(EXERCISE, points=5), 5),
        (HandMark(EXERCISE, points=0), 0),
        (HandMark(bonus=1.5), 4.5),
        (HandMark(bonus=-9), 0),
        (HandMark(EXERCISE, comment="Nice."), 3),
    ],
)
def test_points_by_hand(mark: HandMark, points: float) -> None:
    assert sheet(mark).points == points


def test_points_of_a_check_replace_the_machines() -> None:
    result = sheet().marks[0].result
    assert result
    failed = next(check for check in result.checks if check.earned == 0)
    passed = next(check for check in result.checks if check.earned == 1)
    assert sheet(HandMark(EXERCISE, failed.id, points=0.5)).points == 3.5
    assert sheet(HandMark(EXERCISE, passed.id, points=0)).points == 2
    assert sheet(HandMark(EXERCISE, failed.id, points=0.5), HandMark(EXERCISE, bonus=1)).points == 4.5


def test_lateness_costs_a_share_of_what_was_earned_and_not_of_a_bonus_on_the_whole() -> None:
    made = sheet(HandMark(EXERCISE, points=5), HandMark(bonus=1), late=LATE)
    assert (made.raw_points, made.points, made.marks[0].raw_points, made.marks[0].points) == (6, 5, 5, 4)


def test_who_is_excused_has_no_total() -> None:
    for mark in (HandMark(excused=True), HandMark(EXERCISE, excused=True)):
        made = sheet(mark)
        assert (made.state, made.points, made.max_points) == ("excused", None, None)
        assert (made.marks[0].verdict, made.marks[0].points) == ("excused", None)


def test_points_by_hand_close_what_the_machine_left_open() -> None:
    made = sheet(HandMark(EXERCISE, points=4), graded=samples.DILARA)
    assert (made.state, made.points, made.max_points) == ("complete", 4, 5)
    assert made.marks[0].verdict == "marked by hand"
    assert sheet(HandMark(EXERCISE, comment="Sorry."), graded=samples.DILARA).state == "incomplete"


def test_who_handed_in_nothing_can_get_points() -> None:
    made = sheet(HandMark(EXERCISE, points=2, comment="Shown in the lab."), graded=samples.EMRE)
    assert (made.points, made.marks[0].verdict) == (2, "not handed in")


def test_every_format_says_it() -> None:
    made = sheet(HandMark(EXERCISE, bonus=1, comment="Well *named*."), HandMark(comment="See me."), late=LATE)
    said = letter(made, "c")
    assert "Comment: See me." in said and "By hand: +1 point. Well \\*named\\*." in said
    assert "Handed in 2 days late: 4 points become 3.2." in said
    row = "".join(class_files.rows((samples.EXERCISE,), [made])).splitlines()[1]
    assert ",3.2,5,4,2 days late,complete,Comment: See me. Handed in 2 days late" in row
    data = gradescope.as_data(made)
    assert data["score"] == 3.2 and "By hand: +1 point" in data["output"]
    assert "See me." in "".join(junit.pieces("c", samples.BEGAN, lambda: iter([made])))


@pytest.mark.parametrize("graded", [samples.BAO, samples.DILARA, samples.EMRE])
@pytest.mark.parametrize(
    "mark", [HandMark(bonus=-1), HandMark(excused=True), HandMark(EXERCISE, points=1), HandMark(comment="c")]
)
def test_the_document_keeps_its_schema(graded: samples.GradedSubmission, mark: HandMark) -> None:
    book = samples.gradebook(replace(graded, by_hand=(mark,), lateness=LATE))
    text = "".join(class_files.pieces(book, samples.CLEANER, sheets(book, samples.CLEANER)))
    jsonschema.validate(json.loads(text), samples.SCHEMA)


def test_no_format_takes_an_excused_exercise_for_a_failed_one() -> None:
    made = sheet(HandMark(EXERCISE, excused=True), graded=samples.EMRE)
    assert github.as_data(made)["tests"] == []
    assert all("status" not in test for test in gradescope.as_data(made)["tests"])
