"""The order in which a learner sees the choices: another one for each, the same each time."""

from __future__ import annotations

import hashlib
from dataclasses import replace

from course.content import Choice, Question


def as_seen(questions: tuple[Question, ...], exercise: str, seed: int) -> tuple[Question, ...]:
    """The questions with their choices shuffled by the learner's seed, where that is allowed."""
    return tuple(_shuffled(question, f"{seed}/{exercise}/{question.id}") for question in questions)


def _shuffled(question: Question, place: str) -> Question:
    if question.keep_order:
        return question
    return replace(question, choices=tuple(sorted(question.choices, key=lambda one: _key(place, one))))


def _key(place: str, choice: Choice) -> bytes:
    return hashlib.sha256(f"{place}/{choice.name}".encode()).digest()
