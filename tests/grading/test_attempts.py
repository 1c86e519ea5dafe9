"""When a grading runs again, and what counts in the end."""

from __future__ import annotations

import pytest

from course.content import Exercise, open_course
from course.grading.attempts import ATTEMPTS, MOST_LAG, concluded, deserves_another, doubt_of
from course.grading.author import BUILDS, CheckSpec
from course.grading.outcomes import passed, raised
from course.model import replace
from course.model.feedback import Feedback, Spoilt, TooBusy
from course.model.result import CheckResult, Doubt, Outcome, Result, Timing, Verdict, verdict_of

RIGHT = passed(CheckSpec(BUILDS, "the packages build", 1, False, (), "18-publisher"))
SPEC = CheckSpec("ids", "id goes up", 2, False, (), "18-publisher")
LOST = raised(SPEC, Spoilt("Two messages were lost."))
LATE = raised(SPEC, TooBusy("Too much to do."))
BUG = raised(SPEC, KeyError("ours"))
DARK = replace(LOST, outcome=Outcome.FAILED, feedback=Feedback("It is dark."), doubt=None)
QUIET, BUSY = Timing(), Timing(lag=2 * MOST_LAG)
DIED = Result("18-publisher", Verdict.OUR_ERROR, fault=Feedback("The grading process died."))


@pytest.fixture
def exercise() -> Exercise:
    return open_course().exercise("18-publisher")


def result(check: CheckResult, timing: Timing = QUIET) -> Result:
    checks = (RIGHT, check)
    return Result("18-publisher", verdict_of(checks), checks, timing)


KILLED = replace(result(DARK), doubt=Doubt.KILLED)
DEAF = result(replace(DARK, doubt=Doubt.KILLED))


@pytest.mark.parametrize(
    ("found", "doubt", "again"),
    [
        (result(RIGHT), None, False),
        (result(RIGHT, BUSY), None, False),  # a passed check stays passed
        (result(DARK), None, False),
        (result(DARK, Timing(lag=MOST_LAG)), None, False),
        (result(DARK, BUSY), Doubt.BUSY, True),
        (result(LOST), Doubt.SPOILT, True),
        (result(LOST, BUSY), Doubt.BUSY, True),
        (result(LATE), Doubt.BUSY, True),
        (KILLED, Doubt.KILLED, True),
        (DEAF, Doubt.KILLED, True),
        (replace(KILLED, timing=BUSY), Doubt.BUSY, True),
        (replace(result(LOST), doubt=Doubt.KILLED), Doubt.SPOILT, True),
        (result(BUG), None, True),
        (DIED, None, True),
        (replace(DIED, doubt=Doubt.SPOILT), Doubt.SPOILT, True),
    ],
)
def test_doubts_deserve_another_attempt(found: Result, doubt: Doubt | None, again: bool) -> None:
    assert doubt_of(found) is doubt
    assert [deserves_another(found, attempt + 1) for attempt in range(ATTEMPTS)] == [
        *[again] * (ATTEMPTS - 1),
        False,
    ]


def end(found: Result, exercise: Exercise, attempt: int = ATTEMPTS, *, solution: bool = True) -> Result:
    return concluded(found, attempt, exercise, lambda: solution)


@pytest.mark.parametrize("found", [result(LOST), replace(DIED, doubt=Doubt.SPOILT), result(DARK, BUSY)])
def test_only_the_last_attempt_is_concluded(found: Result, exercise: Exercise) -> None:
    assert end(found, exercise, ATTEMPTS - 1) == found


def test_what_the_submission_may_have_caused_is_its_failure(exercise: Exercise) -> None:
    ended = end(result(LOST), exercise)
    assert ended.verdict is Verdict.NOT_PASSED
    assert ended.checks[0] == RIGHT
    check = ended.checks[1]
    assert (check.outcome, check.doubt) == (Outcome.FAILED, None)
    assert check.feedback is not None
    assert "Two messages were lost." in check.feedback.summary
    assert f"in each of {ATTEMPTS} attempts" in str(check.feedback.seen)


def test_a_process_of_ours_that_dies_of_it_is_its_failure(exercise: Exercise) -> None:
    ended = end(replace(DIED, doubt=Doubt.SPOILT), exercise)
    assert (ended.verdict, ended.fault, ended.doubt) == (Verdict.NOT_PASSED, None, None)
    first, second, *others = ended.checks
    assert (first.id, first.outcome, second.outcome) == (BUILDS, Outcome.PASSED, Outcome.FAILED)
    assert second.feedback is not None and "The grading process died." in second.feedback.summary
    assert others
    assert all(check.skipped_because == f'needs "{second.title}"' for check in others)
    assert ended.max_points == sum(check.points for check in ended.checks if not check.bonus) > 1


@pytest.mark.parametrize("found", [result(LOST), replace(DIED, doubt=Doubt.SPOILT)])
def test_nobody_is_blamed_where_the_solution_ends_like_that_too(found: Result, exercise: Exercise) -> None:
    assert end(found, exercise, solution=False) == found


def test_who_is_killed_in_each_attempt_has_failed(exercise: Exercise) -> None:
    assert end(KILLED, exercise) == end(DEAF, exercise) == result(DARK)


@pytest.mark.parametrize("found", [result(BUG), DIED, result(DARK), result(RIGHT, BUSY)])
def test_our_own_faults_stay_ours_and_the_certain_stays(found: Result, exercise: Exercise) -> None:
    assert end(found, exercise) == found


@pytest.mark.parametrize("found", [result(DARK, BUSY), result(LOST, BUSY), result(LATE)])
def test_a_busy_machine_blames_nobody(found: Result, exercise: Exercise) -> None:
    ended = end(found, exercise)
    assert (ended.verdict, ended.doubt, ended.checks) == (Verdict.OUR_ERROR, Doubt.BUSY, found.checks)
    assert ended.fault is not None and "too busy to judge" in ended.fault.summary
    assert (f"{BUSY.lag:.2f} s" in ended.fault.summary) is (found.timing == BUSY)
