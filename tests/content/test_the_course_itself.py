"""The course that comes with the engine: nothing in it is wrong, missing, or orphaned."""

from __future__ import annotations

from course.content import open_course, problems


def test_nothing_is_wrong_with_it() -> None:
    assert problems(open_course()) == ()


def test_every_exercise_has_a_hint_and_every_one_that_is_not_a_quiz_three() -> None:
    exercises = open_course().exercises()
    assert [e.id for e in exercises if len(e.hints) < (1 if e.questions else 3)] == []


def test_every_question_and_every_exercise_of_files_has_a_mistake() -> None:
    for exercise in open_course().exercises():
        caught = {mistake.caught_by for mistake in exercise.mistakes()}
        assert caught or exercise.local_only, exercise.id
        assert [question.id for question in exercise.questions if question.id not in caught] == []
