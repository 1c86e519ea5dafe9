"""Drawn names in questions, and computed answers."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.content import Exercise, Question, open_course
from course.errors import OurFault
from course.grading.load import mystery_of, questions_for
from course.grading.mystery import AllOf, Mystery, Number, OneOf, Text, fill, resolved
from course.model import replace

FIXTURE = Path(__file__).parents[2] / "fixtures/quiz_course"
BLANK = Question("q", "?", "text", computed=True, explain="So it is.")


@pytest.fixture
def keepers() -> Exercise:
    return open_course(FIXTURE).exercise("05-keepers")


@pytest.fixture
def mystery(keepers: Exercise) -> Mystery:
    found = mystery_of(keepers)
    assert found is not None
    return found


def test_every_learner_gets_other_questions(keepers: Exercise) -> None:
    first, second = questions_for(keepers, 1), questions_for(keepers, 2)
    assert first == questions_for(keepers, 1)
    assert first[0].ask != second[0].ask
    assert [question.form for question in first] == ["number", "text", "all_of", "choice", "text"]
    assert first[4].texts == ("ros2 topic echo",)


def test_a_mystery_needs_a_seed(keepers: Exercise) -> None:
    with pytest.raises(OurFault, match="no seed was given"):
        questions_for(keepers, None)


def test_names_are_filled_in_and_other_braces_stay() -> None:
    assert fill("{topic} of {topic}: {data: 1} {} {Topic} {1}", {"topic": "/a"}) == (
        "/a of /a: {data: 1} {} {Topic} {1}"
    )


def test_an_unknown_name_is_our_fault() -> None:
    with pytest.raises(OurFault, match="no word `topik`; did you mean `topic`"):
        fill("{topik}", {"topic": "/a"})


def test_computed_answers_take_their_forms() -> None:
    number = Number(8.0, "10%", wrong={0.125: "The period."}).put_into(BLANK)
    assert (number.form, number.value, number.tolerance) == ("number", 8.0, 0.8)
    assert number.wrong[0].answer == "0.125"
    assert Text("a", "b", exact=True).put_into(BLANK).texts == ("a", "b")
    assert AllOf("a", "b", wrong={"c": "No."}).put_into(BLANK).form == "all_of"
    choices = OneOf("a", {"b": "No."}).put_into(BLANK).choices
    assert [(choice.name, choice.right, choice.why) for choice in choices] == [
        ("a", True, None),
        ("b", False, "No."),
    ]


@pytest.mark.parametrize(
    ("drop", "what"),
    [("lesson", "lesson.yaml has no"), ("grader", "the grader has no")],
)
def test_lesson_and_grader_must_agree(keepers: Exercise, mystery: Mystery, drop: str, what: str) -> None:
    plan = mystery.draw(3)
    if drop == "lesson":
        keepers = replace(keepers, questions=keepers.questions[1:])
    else:
        mystery.answers(lambda plan: {})
    with pytest.raises(OurFault, match=what):
        resolved(keepers, mystery, plan)


def test_without_a_mystery_computed_answers_are_our_fault(keepers: Exercise, tmp_path: Path) -> None:
    empty = tmp_path / "ch05.py"
    empty.write_text("")
    with pytest.raises(OurFault, match="has no `Mystery` of 05-keepers"):
        questions_for(replace(keepers, grader=empty), 1)


def test_a_mystery_that_is_nowhere() -> None:
    with pytest.raises(OurFault, match=r"no play/05-nowhere\.py"):
        Mystery("05-nowhere", str(FIXTURE / "graders/ch05_lighthouses.py")).draw(1)
