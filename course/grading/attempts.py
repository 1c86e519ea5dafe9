"""Decides when to grade again, and what the last attempt means. No other module decides this.

`check` repeats an attempt at once; `grade` and `validate` do so at the end, with nothing else running. Then
the last attempt counts: what the submission may have caused is its failure, but a busy machine never is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from course.content import Exercise
from course.grading.author import BUILDS
from course.grading.load import load_grader
from course.grading.outcomes import failed, passed, skipped
from course.model import replace
from course.model.feedback import Feedback
from course.model.result import CheckResult, Doubt, Outcome, Result, Verdict, verdict_of

ATTEMPTS = 3
# Seconds. A program that had to wait longer for a processor cannot be judged by the times of its actions.
MOST_LAG = 0.1
_ADVICE = "Look for something that your program sends, prints, or creates in very large amounts."


def doubt_of(result: Result) -> Doubt | None:
    """Why a failure may not be the learner's; None if there is no doubt."""
    doubts = {result.doubt, *(check.doubt for check in result.checks)} - {None}
    late = result.timing.lag > MOST_LAG and (result.verdict is Verdict.NOT_PASSED or bool(doubts))
    if Doubt.BUSY in doubts or late:
        return Doubt.BUSY
    return Doubt.SPOILT if Doubt.SPOILT in doubts else next(iter(doubts), None)


def deserves_another(result: Result, attempt: int) -> bool:
    """Whether to grade again. attempt: the number of this attempt, from 1."""
    doubtful = result.verdict is Verdict.OUR_ERROR or doubt_of(result) is not None
    return doubtful and attempt < ATTEMPTS


def concluded(
    result: Result, attempt: int, exercise: Exercise, solution_passes: Callable[[], bool]
) -> Result:
    """The result that counts after the last attempt, which ran alone; an earlier one's is unchanged.

    solution_passes: grades the course's own solution on this machine. Only if it passes do we blame the
    submission for what went wrong on our side.
    """
    doubt = doubt_of(result) if attempt >= ATTEMPTS else None
    if doubt is Doubt.BUSY:
        return _too_busy(result)
    if doubt is Doubt.KILLED:  # even in the last attempt: nobody outside did that
        return replace(result, doubt=None, checks=tuple(replace(one, doubt=None) for one in result.checks))
    if doubt is Doubt.SPOILT and solution_passes():
        checks = tuple(_checks_of(result, exercise))
        return replace(result, verdict=verdict_of(checks), checks=checks, fault=None, doubt=None)
    return result


def _too_busy(result: Result) -> Result:
    lag = result.timing.lag
    waited = f": a program had to wait {lag:.2f} s for a processor" if lag > MOST_LAG else ""
    fault = Feedback(
        summary=f"This machine was too busy to judge{waited}.",
        advice="Try again when it is less busy. `grade --jobs 1` runs one grading at a time.",
    )
    return replace(result, verdict=Verdict.OUR_ERROR, fault=fault, doubt=Doubt.BUSY)


def _checks_of(result: Result, exercise: Exercise) -> Iterator[CheckResult]:
    """The checks, with our own errors turned into failures; if nothing was judged, all of the exercise's."""
    if result.fault is not None:
        yield from _unjudged(result.fault, exercise)
    for check in result.checks:
        if check.outcome is Outcome.ERROR and check.doubt and check.feedback:
            yield replace(check, outcome=Outcome.FAILED, feedback=_caused(check.feedback), doubt=None)
        else:
            yield check


def _unjudged(fault: Feedback, exercise: Exercise) -> Iterator[CheckResult]:
    """The first check that is not about building fails, and those after it are skipped."""
    first: CheckResult | None = None
    for spec in load_grader(exercise.grader, exercise.id).checks.values():
        if spec.id == BUILDS:
            yield passed(spec)  # otherwise nothing would have run
        elif first is None:
            first = failed(spec, _caused(fault))
            yield first
        else:
            yield skipped(spec, f'needs "{first.title}"')


def _caused(fault: Feedback) -> Feedback:
    seen = f"the same in each of {ATTEMPTS} attempts; the course's own solution can be judged here"
    return Feedback(f"Your program cannot be judged: {fault.summary}", seen=seen, advice=_ADVICE)
