"""The questions of an exercise as one learner gets them."""

from __future__ import annotations

from course.arena.play_module import seed_for
from course.content import Exercise, Question
from course.errors import OurFault
from course.grading.load import declared, load_module
from course.grading.mystery.author import Mystery
from course.grading.mystery.resolve import resolved


def questions_for(exercise: Exercise, seed: int | None) -> tuple[Question, ...]:
    """seed: the learner's own; not needed where no mystery is. Raises OurFault for faults of the course."""
    mystery = mystery_of(exercise)
    if mystery is None:
        return exercise.questions
    if seed is None:
        raise OurFault(f"{exercise.id} is a mystery, and no seed was given to draw it from")
    return resolved(exercise, mystery, mystery.draw(seed_for(exercise.id, seed)))


def mystery_of(exercise: Exercise) -> Mystery | None:
    """What the exercise's grader module says of its mystery; None for an exercise without."""
    if exercise.play is None:
        return None
    mystery = declared(load_module(exercise.grader), Mystery, exercise.id)
    if mystery is None and any(question.computed for question in exercise.questions):
        raise OurFault(f"{exercise.grader.name} has no `Mystery` of {exercise.id}")
    return mystery
