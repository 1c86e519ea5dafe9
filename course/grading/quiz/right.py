"""The right answers of a quiz: for the tests of a course, and for who wants to see them."""

from __future__ import annotations

from collections.abc import Mapping

from course.content import Question


def right_answers(questions: tuple[Question, ...]) -> Mapping[str, tuple[str, ...]]:
    """By question id, as they go into an answers file."""
    return {question.id: right_answer(question) for question in questions}


def right_answer(question: Question) -> tuple[str, ...]:
    if question.choices:
        return tuple(choice.name for choice in question.choices if choice.right)
    if question.form == "number":
        return (f"{question.value:.12g}",)
    return question.texts if question.form == "all_of" else question.texts[:1]
