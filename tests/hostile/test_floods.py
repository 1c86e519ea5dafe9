"""More than anyone can receive: the grader keeps a limited part of it, and still reaches a verdict."""

from __future__ import annotations

import pytest

from course.model.events import MessageSeen, OutputCut
from course.model.result import Verdict
from tests.hostile.world import CLIENT, MB, NODE, SUBSCRIBER, Grade, with_attack

pytestmark = pytest.mark.slow
GUARANTEE = "a flood takes bounded time and memory, and cannot be told apart from its verdict"


def test_on_the_terminal(grade: Grade) -> None:
    """Faster than 10 MB/s. The node works correctly, so it passes; the cut is recorded."""
    graded = grade({NODE: with_attack("flood_terminal")}, guarantee=GUARANTEE)
    assert graded.result.verdict is Verdict.PASSED, graded.result
    assert graded.recording is not None
    (cut,) = (event for event in graded.recording.events if isinstance(event, OutputCut))
    assert cut.dropped > 10 * MB
    assert sum(map(len, graded.printed)) < 2 * MB


@pytest.mark.parametrize("size", [1, 20_000], ids=["short", "long"])
def test_in_the_log(grade: Grade, size: int) -> None:
    graded = grade({NODE: with_attack("flood_log", SIZE=size)}, guarantee=GUARANTEE)
    assert graded.result.verdict is Verdict.PASSED, graded.result
    assert graded.peak < 512 * MB


def test_in_the_log_while_the_grader_searches_it(grade: Grade) -> None:
    text = with_attack("flood_log", SUBSCRIBER, "18-subscriber", SIZE=10)
    graded = grade({SUBSCRIBER: text}, "18-subscriber", guarantee=GUARANTEE)
    assert graded.result.verdict is Verdict.PASSED, graded.result


def test_on_its_topic(grade: Grade) -> None:
    graded = grade({NODE: with_attack("flood_topic", SIZE=1000)}, guarantee=GUARANTEE)
    assert graded.result.verdict is Verdict.NOT_PASSED
    assert "not every 0.50 s" in graded.words("rate")


def test_of_very_large_messages(grade: Grade) -> None:
    """100 MB each: if one arrives in time at all, it is too large to keep."""
    graded = grade({NODE: with_attack("flood_topic", SIZE=100_000_000)}, guarantee=GUARANTEE)
    assert graded.result.verdict is Verdict.NOT_PASSED
    assert graded.recording is not None
    kept = (event for event in graded.recording.events if isinstance(event, MessageSeen))
    assert sum(len(event.data) for event in kept) < 64 * MB


@pytest.mark.parametrize("size", [1, 100_000], ids=["short", "long"])
def test_of_requests(grade: Grade, size: int) -> None:
    text = with_attack("flood_requests", CLIENT, "20-client", SIZE=size)
    graded = grade({CLIENT: text}, "20-client", guarantee=GUARANTEE)
    assert graded.result.verdict is Verdict.NOT_PASSED
    assert "not every 0.50 s" in graded.words("rate")
    assert graded.peak < 768 * MB


@pytest.mark.parametrize("attack", ["many_topics", "many_nodes", "many_parameters"])
def test_of_names(grade: Grade, attack: str) -> None:
    """As many of 100,000 as fit; if the flood slows the node down, that is the node's problem."""
    graded = grade({NODE: with_attack(attack)}, guarantee=GUARANTEE)
    assert graded.result.verdict in (Verdict.PASSED, Verdict.NOT_PASSED), graded.result
    assert graded.check("starts").earned
    assert graded.peak < 512 * MB
