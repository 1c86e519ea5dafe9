"""Every learner sees the choices in a different order, which never changes."""

from __future__ import annotations

from course.content import Choice, Question
from course.grading.quiz.questions import as_seen
from course.model import replace

CHOICES = tuple(Choice(name, name, name == "a") for name in "abcd")
QUESTION = Question("q", "?", "choice", CHOICES)


def order(seed: int, exercise: str = "05-quiz", question: Question = QUESTION) -> str:
    (seen,) = as_seen((question,), exercise, seed)
    assert set(seen.choices) == set(CHOICES)
    return "".join(choice.name for choice in seen.choices)


def test_the_same_learner_sees_the_same() -> None:
    assert order(7) == order(7)


def test_learners_exercises_and_questions_differ() -> None:
    assert len({order(seed) for seed in range(200)}) == 24
    assert len({order(7, f"05-{n}") for n in range(50)}) > 10
    assert len({order(7, question=replace(QUESTION, id=f"q{n}")) for n in range(50)}) > 10


def test_the_right_one_is_anywhere() -> None:
    places = [order(seed).index("a") for seed in range(400)]
    assert all(60 < places.count(place) < 140 for place in range(4))


def test_an_order_that_matters_is_kept() -> None:
    assert order(7, question=replace(QUESTION, keep_order=True)) == "abcd"
