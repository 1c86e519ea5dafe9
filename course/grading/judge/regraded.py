"""A submission's new result when its recording is judged again, and how it differs from the old one."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

from course.content import Exercise, answers_file
from course.grading.protocol import Judged, Judgment, ScenarioState, Unjudged
from course.grading.quiz.questions import check_quiz, with_questions
from course.model import replace
from course.model.result import CheckResult, Outcome, Result, Verdict, verdict_of
from course.spelling import in_one_line

_WHY = 200


def regraded(
    before: Result, exercise: Exercise, judgment: Judgment | None, answers: Path, seed: int | None
) -> Result:
    """The result of an exercise that is judged again.

    judgment: of its recording; None for an exercise with only questions (see `load.runs_programs`).
    answers: a folder with the submission's answers, laid out like a course home. seed: the one it was graded
    with. What was measured while the submission ran (timing, containment) stays the same.
    """
    if judgment is None:
        return replace(check_quiz(exercise, answers, seed), timing=before.timing)
    result = replace(
        before,
        verdict=Verdict.OUR_ERROR if judgment.fault else verdict_of(judgment.checks),
        checks=judgment.checks,
        fault=judgment.fault,
        doubt=None,
        notes=_without_answers(before.notes, exercise),
        bonus=exercise.bonus,
    )
    return with_questions(result, exercise, answers, seed)


def lacks(before: Result, after: Result, rejudged: Judged | Unjudged) -> str | None:
    """Why the evidence is not enough for the current checks, in one line; None if it is.

    It is not enough if there is no recording to judge, or if a check raises anything but a failure, because
    it needs what was not recorded. Nor is it enough if the recording may be from a different scenario and
    the outcome of a check has changed: the missing evidence may be the reason. The same scenario would
    produce the same evidence, so its checks count.
    """
    if isinstance(rejudged, Unjudged):
        return rejudged.what
    if rejudged.judgment.fault:  # no evidence helps a grader that cannot be run
        return None
    for check in after.checks:
        if check.outcome is Outcome.ERROR and check.feedback:
            return f'"{check.title}" cannot be judged from this recording: {check.feedback.summary}'
    if rejudged.scenario is ScenarioState.SAME:
        return None
    known = {check.id: check.outcome for check in before.checks}
    judged = {check.id for check in rejudged.judgment.checks}
    moved = next((c for c in after.checks if c.id in judged and known.get(c.id) is not c.outcome), None)
    if moved is None:
        return None
    how = "ended differently before" if moved.id in known else "is new"
    return f'{_OTHERWISE[rejudged.scenario]}, and "{moved.title}" {how}.'


_OTHERWISE = {
    ScenarioState.CHANGED: "The scenario has changed since",
    ScenarioState.UNKNOWN: "The recording does not say which scenario made it",
}


def _without_answers(notes: tuple[str, ...], exercise: Exercise) -> tuple[str, ...]:
    """The notes without those about answers, which are judged again."""
    return tuple(note for note in notes if not note.startswith(f"{answers_file(exercise.id)}:"))


class MoveCause(str, Enum):
    """Why the marks changed. GRADER: nothing could be judged, either now or before."""

    ADDED = "check added"
    GONE = "check removed"
    OUTCOME = "outcome"
    POINTS = "points"
    GRADER = "grader"


@dataclass(frozen=True)
class Move:
    """One check whose outcome or points changed.

    check: its id; empty if it is about the whole exercise. before, after: points earned. most_before,
    most_after: points that were possible (0 for a bonus check, or one that was not applicable or did not
    exist). why: one line.
    """

    check: str
    title: str
    cause: MoveCause
    before: float
    after: float
    most_before: float
    most_after: float
    why: str


def moves(before: Result, after: Result) -> tuple[Move, ...]:
    """How the marks changed between two results, in the order of the checks; removed checks come last.

    A check with nothing but different feedback has not changed.
    """
    old = {check.id: check for check in before.checks}
    new = {check.id: check for check in after.checks}
    return (
        *_of_the_grader(before, after),
        *(move for check in after.checks for move in _of_a_check(old.get(check.id), check)),
        *(move for check in before.checks if check.id not in new for move in _of_a_check(check, None)),
    )


def _of_the_grader(before: Result, after: Result) -> Iterator[Move]:
    if (before.fault is None) is (after.fault is None):
        return
    why = f"could not be judged: {after.fault.summary}" if after.fault else "could not be judged before"
    yield Move(
        "",
        "the exercise",
        MoveCause.GRADER,
        before.points,
        after.points,
        before.max_points,
        after.max_points,
        _line(why),
    )


def _of_a_check(old: CheckResult | None, new: CheckResult | None) -> Iterator[Move]:
    cause, why = _why(old, new)
    one = new or old
    if cause is not None and one is not None:
        yield Move(
            one.id,
            one.title,
            cause,
            old.earned if old else 0.0,
            new.earned if new else 0.0,
            _most(old),
            _most(new),
            _line(why),
        )


def _why(old: CheckResult | None, new: CheckResult | None) -> tuple[MoveCause | None, str]:
    if new is None:
        return MoveCause.GONE, "this check was removed"
    if old is None:
        return MoveCause.ADDED, f"new check: {_said(new)}"
    if old.outcome is not new.outcome:
        points = f" ({_points(old, new)})" if _worth(old) != _worth(new) else ""
        return MoveCause.OUTCOME, f"{old.outcome.value} → {_said(new)}{points}"
    if _worth(old) != _worth(new):
        return MoveCause.POINTS, _points(old, new)
    return None, ""


def _said(check: CheckResult) -> str:
    because = check.feedback.summary if check.feedback else check.skipped_because
    told = because and check.outcome is not Outcome.PASSED
    return f"{check.outcome.value}: {because}" if told else check.outcome.value


def _worth(check: CheckResult) -> tuple[float, bool]:
    return check.points, check.bonus


def _points(old: CheckResult, new: CheckResult) -> str:
    return f"worth {_amount(new)}, was {_amount(old)}"


def _amount(check: CheckResult) -> str:
    return f"{check.points:g}{' as a bonus' if check.bonus else ''}"


def _most(check: CheckResult | None) -> float:
    if check is None or check.bonus or check.outcome is Outcome.NOT_APPLICABLE:
        return 0.0
    return check.points


def _line(text: str) -> str:
    line = in_one_line(text)
    return line if len(line) <= _WHY else f"{line[: _WHY - 1]}…"
