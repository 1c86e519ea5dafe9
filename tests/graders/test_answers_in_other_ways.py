"""Right answers count however they are written: two other ways for every quiz and mystery."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
import yaml

from course.content import Course, Exercise, Question, answers_file, open_course
from course.grading import trial
from course.grading.load import questions_for
from course.grading.quiz.judge import right_answer
from course.grading.trial_answers import SEED
from course.validate.claims import earns_all

from .conftest import Check

pytestmark = pytest.mark.slow

ASKED = [exercise for exercise in open_course().exercises() if exercise.questions]
Answer = Callable[[Question], object]


def in_other_words(question: Question) -> object:
    """Choices in full, another accepted text, capitals where they do not matter, a reversed list."""
    if question.choices:
        texts = [choice.text for choice in question.choices if choice.right]
        return texts[0] if question.form == "choice" else texts[::-1]
    if question.form == "number":
        return question.value + question.tolerance / 2
    texts = [text if question.exact else text.upper() for text in question.texts]
    return texts[::-1] if question.form == "all_of" else texts[-1]


def by_hand(question: Question) -> object:
    """What the course itself would write, in alphabetical order and without comments."""
    texts = right_answer(question)
    return texts[0] if len(texts) == 1 else list(texts)


@pytest.mark.parametrize("way", [in_other_words, by_hand], ids=lambda way: way.__name__)
@pytest.mark.parametrize("exercise", ASKED, ids=lambda exercise: exercise.id)
def test_right_answers_count_however_they_are_written(
    exercise: Exercise, way: Answer, course: Course, home: Path, check: Check
) -> None:
    trial.lay_solution(course, exercise, home)
    answers = {question.id: way(question) for question in questions_for(exercise, SEED)}
    (home / answers_file(exercise.id)).write_text(yaml.safe_dump(answers, allow_unicode=True))
    assert earns_all(check(exercise, home)) == []
