"""Grader of chapter 12: a node that logs a count twice per second."""

from __future__ import annotations

import re

import pytest

from course.arena.arena import Arena
from course.evidence.recording import Recording
from course.evidence.topic_view import LogLine, expect_period
from course.feedback import Failure, Feedback
from course.grading.author import Grader
from course.grading.expect.counts import expect_counting
from course.grading.expect.graph import expect_node
from course.grading.expect.logs import expect_logged
from course.grading.expect.manifests import expect_dependency
from course.grading.expect.programs import (
    expect_clean_end,
    expect_clean_interrupt,
    expect_executable,
    expect_running,
)
from course.grading.explain.timers import timer_cause, timer_places

PACKAGE = "python_package_with_a_node"
NODE = "print_forever_node"
OLD = "sample_python_node"
GREETING = f"Hi from {PACKAGE}."
FIRST = "Printed 0 times."
LINE = re.compile(r"Printed (\d+) times\.")
ENOUGH = 5

print_forever = Grader("12-print-forever")


@print_forever.scenario
def five_messages_and_the_old_program(arena: Arena) -> None:
    """Five messages are four intervals; the old program ends by itself."""
    old = arena.run(PACKAGE, OLD)
    node = arena.run(PACKAGE, NODE)
    if node and arena.until(lambda: arena.graph.nodes, timeout=15, while_running=node):
        arena.until(lambda: arena.logged("") or arena.printed("Print"), timeout=4, while_running=node)
        arena.until(
            lambda: arena.logged("Print") >= ENOUGH or arena.printed("Print") > ENOUGH + 1,
            timeout=4,
            while_running=node,
        )
        # What a quick node printed may reach the log a moment later.
        arena.until(lambda: arena.logged("Print") >= ENOUGH, timeout=1, while_running=node)
    arena.interrupt(node)
    if old:
        old.wait(5)


def counted(recording: Recording) -> tuple[LogLine, ...]:
    return tuple(line for line in recording.log if LINE.search(line.text))


@print_forever.check("starts", "the node starts and keeps running")
def starts(recording: Recording) -> None:
    expect_running(recording, NODE)


@print_forever.check("node_name", "the node is called /print_forever", needs="starts")
def node_name(recording: Recording) -> None:
    expect_node(recording, "/print_forever")


@print_forever.check("logs", "it logs `Printed N times.` at level INFO", needs="starts")
def logs(recording: Recording) -> None:
    expect_logged(recording, NODE, counted(recording), FIRST, "Print")


@print_forever.check("counts", "the count goes up by one, from 0", needs="logs")
def counts(recording: Recording) -> None:
    lines = counted(recording)
    expect_counting(
        lines,
        LINE,
        first=FIRST,
        begin="Begin with a count of 0, and add one after the message is logged, not before.",
        step="Keep the count in the node (`self.count`) and add one each time the timer calls.",
    )
    if len(lines) < ENOUGH:
        raise Failure(too_few(recording, lines))


def too_few(recording: Recording, lines: tuple[LogLine, ...]) -> Feedback:
    cause = timer_cause(recording.sources)
    return Feedback(
        summary=f"The node logged only {len(lines)} time{'s' if len(lines) > 1 else ''}; it "
        "should go on forever.",
        expected="a message every 0.5 s",
        seen=f"{len(lines)} in all",
        where=cause.where if cause else timer_places(recording.sources),
        advice=cause.text
        if cause
        else "Let a timer of 0.5 s call the function that logs, with `create_timer`.",
        details=tuple(line.text for line in lines[:3]),
    )


@print_forever.check("rate", "it logs twice per second", needs="logs")
def rate(recording: Recording) -> None:
    times = tuple(line.t for line in counted(recording))
    if len(times) < ENOUGH:
        pytest.skip("there are too few messages to tell")
    expect_period(times, 0.5, what="log messages", advice="The period of `create_timer` is in seconds: 0.5.")


@print_forever.check("old_executable", "the old program still runs", needs="builds")
def old_executable(recording: Recording) -> None:
    expect_executable(recording, OLD)
    expect_clean_end(recording, OLD)
    text = recording.process(OLD).text
    if GREETING not in (line.strip() for line in text):
        raise Failure(
            Feedback(
                summary=f"`{OLD}` no longer prints `{GREETING}`",
                expected=GREETING,
                seen=text[0] if text else "nothing",
                advice=f"Leave `{OLD}.py` as it was; the new node has a module of its own.",
            )
        )


@print_forever.check("declares_rclpy", "package.xml declares rclpy")
def declares_rclpy(recording: Recording) -> None:
    expect_dependency(recording, PACKAGE, "rclpy")


@print_forever.check("interrupt", "Ctrl+C ends it in silence", needs="starts")
def interrupt(recording: Recording) -> None:
    expect_clean_interrupt(recording, NODE)
