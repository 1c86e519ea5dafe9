"""Points and totals: zero, unknown, and not counted."""

from __future__ import annotations

from course.model import replace
from course.model.gradebook import Gradebook, GradedExercise, GradedSubmission, Person
from course.model.result import CheckResult, Outcome, Result, Verdict, not_applicable
from course.report.gradebook.cleaning import Cleaner
from course.report.gradebook.sheets import Sheet, sheets
from tests.report.gradebook import samples

ONE, TWO = GradedExercise("one", "One", 3), GradedExercise("two", "Two", 2, bonus=True)
PASSED = CheckResult("a", "A", 3, Outcome.PASSED)
EXTRA = CheckResult("b", "B", 0.5, Outcome.PASSED, bonus=True)


def sheet(*results: Result, source: str = "a.zip") -> Sheet:
    graded = (GradedSubmission(Person("a"), source, results),)
    book = Gradebook("c", (ONE, TWO), graded, samples.BEGAN, samples.ENDED)
    return next(sheets(book, Cleaner()))


def done(exercise: str, *checks: CheckResult) -> Result:
    return Result(exercise, Verdict.PASSED, checks)


def test_bonus_adds_points_but_is_not_asked_for() -> None:
    made = sheet(done("one", PASSED, EXTRA), done("two", replace(PASSED, points=2)))
    assert (made.points, made.max_points, made.state) == (5.5, 3, "complete")


def test_what_was_not_handed_in_brings_nothing_and_counts() -> None:
    made = sheet(done("two", PASSED))
    assert (made.marks[0].verdict, made.marks[0].points, made.marks[0].max_points) == ("not handed in", 0, 3)
    assert (made.points, made.max_points, made.state) == (3, 3, "complete")
    assert sheet(source="").state == "not handed in"


def test_an_error_of_ours_leaves_the_total_open() -> None:
    for verdict in (Verdict.OUR_ERROR, Verdict.NOT_AVAILABLE):
        made = sheet(Result("one", verdict, (PASSED,)), done("two", PASSED))
        assert (made.marks[0].points, made.marks[0].max_points) == (None, None)
        assert (made.points, made.max_points, made.state) == (None, None, "incomplete")
        assert (made.judged_points, made.judged_max) == (3, 0)


def test_what_does_not_apply_is_in_no_total() -> None:
    made = sheet(not_applicable("one", "own machine"), done("two", PASSED))
    assert (made.points, made.max_points, made.state) == (3, 0, "complete")
    assert made.marks[0].points is None


def test_marks_stand_in_the_order_of_the_exercises_and_strangers_are_left_out() -> None:
    made = sheet(done("three", PASSED), done("two", PASSED), done("one", PASSED))
    assert [(mark.exercise.id, mark.verdict) for mark in made.marks] == [("one", "passed"), ("two", "passed")]


def test_sums_have_no_tails() -> None:
    tenths = tuple(CheckResult(f"t{n}", "T", 0.1, Outcome.PASSED) for n in range(3))
    assert str(sheet(done("one", *tenths)).points) == "0.3"


def test_where_a_submission_lies_is_not_told() -> None:
    assert sheet(source="/srv/class/ada.zip").source == "ada.zip"
    assert sheet(source="week1/ada.zip").source == "week1/ada.zip"


def test_a_class_is_read_one_submission_at_a_time() -> None:
    read: list[int] = []

    class Store:
        def __iter__(self):  # type: ignore[no-untyped-def]
            for number in range(1000):
                read.append(number)
                yield GradedSubmission(Person(str(number)), "")

    book = Gradebook("c", (ONE,), Store(), samples.BEGAN, samples.ENDED)
    walk = sheets(book, Cleaner())
    assert next(walk).person.id == "0" and len(read) == 1
    assert sum(1 for _ in sheets(book, Cleaner())) == 1000
