"""The questions of an exercise as checks. Needs no ROS, starts nothing, takes milliseconds."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from pathlib import Path

from course.content import Choice, Exercise, Question
from course.errors import OurFault
from course.grading.load import questions_for
from course.grading.outcomes import our_error
from course.grading.quiz.answers import Answers, missing, read_answers
from course.grading.quiz.judge import failed, judge, skipped
from course.model import replace
from course.model.feedback import Failure, Feedback
from course.model.result import CheckResult, Result, Verdict, verdict_of


def check_quiz(exercise: Exercise, home: Path, seed: int | None = None) -> Result:
    """Judge the answers in the course home `home` to an exercise that only has questions."""
    return with_questions(Result(exercise.id, Verdict.PASSED, bonus=exercise.bonus), exercise, home, seed)


def with_questions(result: Result, exercise: Exercise, home: Path, seed: int | None) -> Result:
    """`result` with the checks of the exercise's questions after its own."""
    if not exercise.questions or result.verdict is Verdict.NOT_AVAILABLE:
        return result
    try:
        _refuse_same_ids(exercise, result.checks)
        checks, notes = _judged(exercise, home, seed)
    except Exception as error:  # noqa: BLE001 - a course's own code computes answers: its faults are ours
        return replace(result, verdict=Verdict.OUR_ERROR, fault=our_error(error))
    checks = (*result.checks, *checks)
    verdict = Verdict.OUR_ERROR if result.fault else verdict_of(checks)
    return replace(result, verdict=verdict, checks=checks, notes=(*result.notes, *notes))


def _judged(
    exercise: Exercise, home: Path, seed: int | None
) -> tuple[tuple[CheckResult, ...], tuple[str, ...]]:
    questions = questions_for(exercise, seed)
    try:
        answers = read_answers(home, exercise.id)
    except Failure as failure:
        return tuple(_none_of(questions, failure.feedback)), ()
    if answers is None:
        return tuple(_none_of(questions, missing(home, exercise.id))), ()
    known = frozenset(question.id for question in questions)
    return tuple(judge(question, answers, known) for question in questions), _strangers(answers, known)


def _none_of(questions: tuple[Question, ...], because: Feedback) -> Iterator[CheckResult]:
    """The first question fails and says why none was judged."""
    first, *others = questions
    yield failed(first, because)
    yield from (skipped(question, "there are no answers to judge") for question in others)


def _strangers(answers: Answers, known: frozenset[str]) -> tuple[str, ...]:
    found = answers.unknown(known)
    return tuple(f"{answers.file}:{given.line}: there is no question `{name[:80]}`." for name, given in found)


def _refuse_same_ids(exercise: Exercise, checks: tuple[CheckResult, ...]) -> None:
    both = {check.id for check in checks} & {question.id for question in exercise.questions}
    if both:
        raise OurFault(f"{exercise.id} has a check and a question named {min(both)}")


def as_seen(questions: tuple[Question, ...], exercise: str, seed: int) -> tuple[Question, ...]:
    """The questions with their choices shuffled by the learner's seed, where that is allowed."""
    return tuple(_shuffled(question, f"{seed}/{exercise}/{question.id}") for question in questions)


def _shuffled(question: Question, place: str) -> Question:
    if question.keep_order:
        return question
    return replace(question, choices=tuple(sorted(question.choices, key=lambda one: _key(place, one))))


def _key(place: str, choice: Choice) -> bytes:
    return hashlib.sha256(f"{place}/{choice.name}".encode()).digest()
