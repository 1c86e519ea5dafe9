"""From what the checks say of an old recording to the new result, and whether the recording was enough."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from course.content import Exercise, answers_file
from course.grading.channel import Judgement
from course.grading.quiz.check import check_quiz, with_questions
from course.grading.rejudge.model import Problem, Rejudged, Scenario
from course.grading.result import Outcome, Result, Verdict, verdict_of


def regraded(
    before: Result, exercise: Exercise, judgement: Judgement | None, answers: Path, seed: int | None
) -> Result:
    """The result of an exercise that is judged again.

    judgement: of its recording; None for an exercise of questions alone (`load.runs_programs`). answers: a
    folder in which the submission's answers lie as in a course home. seed: the one it was graded with.
    What was measured while the submission ran (timing, containment) stays as it was.
    """
    if judgement is None:
        return replace(check_quiz(exercise, answers, seed), timing=before.timing)
    result = replace(
        before,
        verdict=Verdict.OUR_ERROR if judgement.fault else verdict_of(judgement.checks),
        checks=judgement.checks,
        fault=judgement.fault,
        notes=_without_answers(before.notes, exercise),
        bonus=exercise.bonus,
    )
    return with_questions(result, exercise, answers, seed)


def lacks(before: Result, after: Result, rejudged: Rejudged | Problem) -> str | None:
    """Why the evidence does not suffice for the checks of now, in one line; None when it does.

    It does not suffice where there is no recording to judge; where a check ran into anything but a
    failure: it asks for what was not recorded; and where the scenario is not the one that made the
    recording, and a check says something else than before: a new one may pass or fail for want of what
    today's scenario would have done. The same scenario would bring the same evidence, so its checks count.
    """
    if isinstance(rejudged, Problem):
        return rejudged.what
    if rejudged.judgement.fault:  # no evidence helps a grader that cannot be run
        return None
    for check in after.checks:
        if check.outcome is Outcome.ERROR and check.feedback:
            return f"«{check.title}» cannot be judged from this recording: {check.feedback.summary}"
    if rejudged.scenario is Scenario.SAME:
        return None
    known = {check.id: check.outcome for check in before.checks}
    judged = {check.id for check in rejudged.judgement.checks}
    moved = next((c for c in after.checks if c.id in judged and known.get(c.id) is not c.outcome), None)
    if moved is None:
        return None
    how = "ended otherwise before" if moved.id in known else "is new"
    return f"{_OTHERWISE[rejudged.scenario]}, and «{moved.title}» {how}."


_OTHERWISE = {
    Scenario.CHANGED: "The scenario has changed since",
    Scenario.UNKNOWN: "The recording does not say which scenario made it",
}


def _without_answers(notes: tuple[str, ...], exercise: Exercise) -> tuple[str, ...]:
    """Without what was noted of the answers: they are judged again, too."""
    return tuple(note for note in notes if not note.startswith(f"{answers_file(exercise.id)}:"))
