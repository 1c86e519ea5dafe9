"""Puts right and wrong answers, and acts in mysteries, into trial homes.

If the solution has no answers file, the right answers are taken from the lesson, or computed
for a mystery: all trials use the same seed.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from course.arena.mystery_module import log_file, seed_for, write_log
from course.content import Exercise, answers_file
from course.content.entries import Given
from course.content.layout import STATE
from course.errors import ContentError
from course.evidence.acts import Act
from course.grading.load import mystery_of, questions_for
from course.grading.mystery import fill
from course.grading.quiz.answers import answers_text, read_answers
from course.grading.quiz.judge import right_answers
from course.spelling import did_you_mean

# The seed of the imaginary learner who did everything right.
SEED = 1994


def lay_answers(exercise: Exercise, home: Path) -> None:
    """Write the right answers, unless there is an answers file, and the acts of a mystery."""
    if exercise.questions and not (home / answers_file(exercise.id)).exists():
        answers = right_answers(questions_for(exercise, SEED))
        _write(exercise, home, answers)
    mystery = mystery_of(exercise)
    if mystery is not None:
        acts = tuple(Act(name) for name in mystery.acts_function(mystery.draw(seed_for(exercise.id, SEED))))
        if acts:
            write_log(log_file(home / STATE, exercise.id), exercise.id, acts)


def change_answers(exercise: Exercise, home: Path, changes: Mapping[str, Given], where: Path) -> None:
    """Replace some answers; `{name}` in the new ones is a word of the mystery.

    where: the file that asks for it. Raises ContentError if there is no such question.
    """
    known = [question.id for question in exercise.questions]
    for name in changes:
        if name not in known:
            what = f"{exercise.id} has no question `{name}`{did_you_mean(name, known)}"
            raise ContentError(what, f"allowed: {', '.join(known)}", file=where, key="answers")
    answers = read_answers(home, exercise.id)
    given = {name: one.texts for name, one in answers.given.items()} if answers else {}
    words = _words(exercise)
    for name, change in changes.items():
        texts = [change] if isinstance(change, str) else change
        given[name] = tuple(fill(text, words) if words else text for text in texts)
    _write(exercise, home, given)


def _words(exercise: Exercise) -> Mapping[str, object]:
    mystery = mystery_of(exercise)
    return mystery.words_function(mystery.draw(seed_for(exercise.id, SEED))) if mystery else {}


def _write(exercise: Exercise, home: Path, answers: Mapping[str, tuple[str, ...]]) -> None:
    file = home / answers_file(exercise.id)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(answers_text(exercise.id, exercise.questions, answers), encoding="utf-8")
