"""Graders of chapter 18: a publisher and a subscriber of our own messages."""

from __future__ import annotations

from course.arena.arena import Arena
from course.evidence.recording import Recording
from course.grading.author import Grader
from course.grading.expect.graph import expect_endpoint, expect_node, expect_type
from course.grading.expect.manifests import expect_dependency
from course.grading.expect.programs import expect_clean_interrupt, expect_running

PACKAGE = "python_package_that_uses_the_messages"
QUOTE = "package_with_interfaces/msg/AmazingQuote"
TOPIC = "/amazing_quote"
PUBLISHER = "amazing_quote_publisher_node"

publisher = Grader("18-publisher")


@publisher.scenario
def five_quotes(arena: Arena) -> None:
    quotes = arena.subscribe(TOPIC, QUOTE)
    node = arena.run(PACKAGE, PUBLISHER)
    arena.until(lambda: quotes.count >= 5, timeout=8, while_running=node)
    arena.interrupt(node)


@publisher.check("starts", "the node starts and keeps running", needs="builds")
def publisher_starts(recording: Recording) -> None:
    expect_running(recording, PUBLISHER)


@publisher.check("rate", "publishes twice per second", needs="starts")
def publisher_rate(recording: Recording) -> None:
    recording.topic(TOPIC).expect_period(0.5)

@publisher.check("interrupt", "ctrlc", needs="starts")
def publisher_int(recording: Recording) -> None:
    expect_clean_interrupt(recording, PUBLISHER)
