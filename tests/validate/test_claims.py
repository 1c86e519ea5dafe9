"""A result confirms a claim, or says in words what contradicts it."""

from __future__ import annotations

import pytest

from course.content import Mistake
from course.model import replace
from course.model.feedback import Feedback, Location
from course.model.result import CheckResult, Outcome, Result, Verdict, verdict_of
from course.validate.claims import does_not_pass, earns_all, is_caught, words_of

BUILDS = CheckResult("builds", "it builds", 1, Outcome.PASSED)
RATE = CheckResult("rate", "twice a second", 2, Outcome.PASSED)
NAME = CheckResult("name", "its name", 1, Outcome.PASSED)
EXTRA = CheckResult("extra", "and more", 0.5, Outcome.PASSED, bonus=True)
SLOW = replace(
    RATE, outcome=Outcome.FAILED, feedback=Feedback("It publishes once.", expected="2 Hz", seen="1 Hz")
)
OURS = replace(RATE, outcome=Outcome.ERROR, feedback=Feedback("The grader itself failed here."))
TOO_SLOW = Mistake("too-slow", "18-x", "It is slow", (), "rate", ("2 Hz", "once"))


def result(*checks: CheckResult) -> Result:
    return Result("18-x", verdict_of(checks), checks)


def failed(check: CheckResult) -> CheckResult:
    return replace(check, outcome=Outcome.FAILED, feedback=Feedback(f"{check.id} is wrong."))


def test_all_points() -> None:
    assert earns_all(result(BUILDS, RATE, EXTRA)) == []


@pytest.mark.parametrize(
    ("got", "words"),
    [
        (result(BUILDS, SLOW), "`rate` failed: It publishes once."),
        (result(BUILDS, failed(EXTRA)), "`extra` failed: extra is wrong."),
        (result(BUILDS, OURS), "`rate` could not be judged: The grader itself failed here."),
        (Result("18-x", Verdict.OUR_ERROR, fault=Feedback("It fell over.")), "It fell over."),
        (
            result(BUILDS, replace(RATE, outcome=Outcome.SKIPPED, skipped_because='needs "x"')),
            '`rate` was skipped: needs "x"',
        ),
        (
            result(BUILDS, replace(RATE, outcome=Outcome.NOT_APPLICABLE, skipped_because="no g++")),
            "`rate` was not applicable: no g++",
        ),
        (Result("18-x", Verdict.NOT_APPLICABLE), 'its verdict is "not applicable"'),
        (result(EXTRA, replace(NAME, points=0)), "0.5 of 0 points"),
    ],
)
def test_not_all_points(got: Result, words: str) -> None:
    assert words in " ".join(earns_all(got))


def test_a_starter_that_does_not_pass() -> None:
    assert does_not_pass(result(BUILDS, SLOW), builds=True) == []
    assert does_not_pass(result(failed(BUILDS), SLOW)) == []


@pytest.mark.parametrize(
    ("got", "words"),
    [
        (result(BUILDS, RATE), "it passes"),
        (result(failed(BUILDS), SLOW), "`builds` failed"),
        (result(BUILDS, OURS), "could not be judged"),
        (Result("18-x", Verdict.OUR_ERROR, fault=Feedback("It fell over.")), "It fell over."),
        (Result("18-x", Verdict.NOT_APPLICABLE), "not applicable"),
    ],
)
def test_a_starter_that_proves_nothing(got: Result, words: str) -> None:
    assert words in " ".join(does_not_pass(got, builds=True))


def test_a_mistake_that_is_caught() -> None:
    assert is_caught(result(BUILDS, SLOW, NAME), TOO_SLOW) == []
    both = replace(TOO_SLOW, also_fails=("name",))
    assert is_caught(result(BUILDS, SLOW, failed(NAME)), both) == []


def test_a_mistake_in_a_bonus_spares_the_pass() -> None:
    sloppy = replace(TOO_SLOW, caught_by="extra", says=())
    assert is_caught(result(BUILDS, RATE, failed(EXTRA)), sloppy) == []


@pytest.mark.parametrize(
    ("got", "mistake", "words"),
    [
        (result(BUILDS, RATE), TOO_SLOW, "`rate` does not catch it: the check passed"),
        (result(BUILDS, RATE, failed(NAME)), TOO_SLOW, "it fails `name`, too: name is wrong."),
        (result(BUILDS, SLOW, failed(NAME)), TOO_SLOW, "it fails `name`, too"),
        (result(BUILDS, SLOW), replace(TOO_SLOW, says=("3 Hz",)), 'does not say "3 Hz", but: It publishes'),
        (result(BUILDS, SLOW, NAME), replace(TOO_SLOW, also_fails=("name",)), "it does not fail `name`"),
        (result(BUILDS, SLOW), replace(TOO_SLOW, caught_by="rat"), "no such check; there are builds, rate"),
        (result(BUILDS, SLOW, failed(NAME)), replace(TOO_SLOW, says=("3",)), "it fails `name`, too"),
        (result(BUILDS, SLOW, replace(OURS, id="x")), TOO_SLOW, "`x` could not be judged"),
        (Result("18-x", Verdict.OUR_ERROR, fault=Feedback("It fell over.")), TOO_SLOW, "It fell over."),
        (replace(result(BUILDS, SLOW), verdict=Verdict.PASSED), TOO_SLOW, 'its verdict is "passed"'),
    ],
)
def test_a_mistake_that_slips_through(got: Result, mistake: Mistake, words: str) -> None:
    assert words in " ".join(is_caught(got, mistake))


def test_all_that_a_learner_reads_counts() -> None:
    told = Feedback("a", "b", "c", (Location("d.py", 3),), "e", ("f",))
    assert words_of(told).splitlines() == ["a", "b", "c", "e", "d.py:3", "f"]
    assert words_of(None) == ""
