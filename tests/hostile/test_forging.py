"""Programs that want a better verdict than they deserve, or pretend to be the grader."""

from __future__ import annotations

import pytest

from course.model.result import Verdict
from tests.hostile.world import CLIENT, NODE, SUBSCRIBER, Grade, with_attack

pytestmark = pytest.mark.slow


def test_a_program_that_writes_verdicts(grade: Grade) -> None:
    """To every descriptor and file, and then it ends normally."""
    graded = grade({NODE: with_attack("forged", ENDING="exit")}, guarantee="nobody can write a verdict")
    assert graded.result.verdict is Verdict.NOT_PASSED
    assert graded.failed == ("starts",)
    assert "ended on its own" in graded.words("starts")


def test_a_program_that_becomes_another(grade: Grade) -> None:
    """One with the right name, which runs until Ctrl+C."""
    graded = grade({NODE: with_attack("forged", ENDING="exec")}, guarantee="a name alone earns nothing")
    assert graded.failed == ("node_name", "topic_exists")
    assert graded.check("starts").earned


def test_a_node_with_the_graders_name(grade: Grade) -> None:
    graded = grade({NODE: with_attack("impostor", SPEAKS=False)}, guarantee="the grader knows itself")
    assert any(line.startswith("found ['_ros2course_") for line in graded.printed)
    assert graded.failed == ()
    assert graded.result.verdict is Verdict.PASSED, graded.result


def test_a_subscriber_that_hears_what_it_says_itself(grade: Grade) -> None:
    """Its own messages in the log do not count: the grader's words are random each time."""
    text = with_attack("impostor", SUBSCRIBER, "18-subscriber", SPEAKS=True)
    honest = "{message.quote}"
    assert honest in text
    text = text.replace(honest, "a quote that nobody sent")
    graded = grade({SUBSCRIBER: text}, "18-subscriber", guarantee="only the grader's own messages count")
    assert graded.result.verdict is Verdict.NOT_PASSED
    assert not graded.check("content").earned


def test_a_client_that_answers_itself(grade: Grade) -> None:
    """Its answers may come first, but then the grader's answers are missing in its log."""
    text = with_attack("answers_itself", CLIENT, "20-client")
    graded = grade({CLIENT: text}, "20-client", guarantee="only the grader's own answers count")
    assert graded.result.verdict is Verdict.NOT_PASSED
    assert "logged incompletely" in graded.words("logs")


def test_one_that_talks_to_the_graders_own_services(grade: Grade) -> None:
    graded = grade({NODE: with_attack("flood_answers")}, guarantee="the grader offers nothing to ask it")
    assert graded.result.verdict in (Verdict.PASSED, Verdict.NOT_PASSED), graded.result
