"""Grader of chapter 12: a node that logs a count twice per second."""

from __future__ import annotations

import re

import pytest

from course.api import (
    Arena,
    Failure,
    Feedback,
    Grader,
    LogLine,
    Recording,
    cause_of_silence,
    expect_clean_end,
    expect_clean_interrupt,
    expect_dependency,
    expect_executable,
    expect_logged,
    expect_node,
    expect_period,
    expect_running,
    slips,
)
from lib.counts import await_counted, expect_counting

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
    """Record five messages, which make four intervals; the old program ends by itself."""
    old = arena.run(PACKAGE, OLD)
    node = arena.run(PACKAGE, NODE)
    await_counted(arena, node, "Print", ENOUGH, seconds=4)
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
        sources=recording.sources,
        terminal=recording.process(NODE).text,
        first=FIRST,
        begin="Start with a count of 0, and add one after each message that you log, not before it.",
        step="Keep the count in the node (`self.count`), and add one each time the callback runs.",
        cause=slips.first(recording.sources, slips.compared, slips.never_counts, slips.local_copy),
    )
    if len(lines) < ENOUGH:
        raise Failure(too_few(recording, lines))


def too_few(recording: Recording, lines: tuple[LogLine, ...]) -> Feedback:
    cause = cause_of_silence(
        recording, NODE, slips.logged_seldom, look_at="does a 0.5 s timer call the function that logs?"
    )
    return Feedback(
        summary=f"The node logged only {len(lines)} time{'s' if len(lines) > 1 else ''}. It "
        "should never stop.",
        expected="a message every 0.5 s",
        seen=f"{len(lines)} in total",
        where=cause.where,
        advice=cause.text,
        details=tuple(line.text for line in lines[:3]),
    )


@print_forever.check("rate", "it logs twice per second", needs="logs")
def rate(recording: Recording) -> None:
    times = tuple(line.t for line in counted(recording))
    if len(times) < ENOUGH:
        pytest.skip("there are too few messages to judge")
    expect_period(times, 0.5, what="log messages", program=recording)


@print_forever.check("old_executable", "the old program still runs", needs="builds")
def old_executable(recording: Recording) -> None:
    expect_executable(recording, OLD)
    expect_clean_end(recording, OLD)
    text = recording.process(OLD).text
    if GREETING not in (line.strip() for line in text):
        raise Failure(
            Feedback(
                summary=f"`{OLD}` no longer prints `{GREETING}`.",
                expected=GREETING,
                seen=text[0] if text else "nothing",
                advice=f"Leave `{OLD}.py` as it was. The new node has its own module.",
            )
        )


@print_forever.check("declares_rclpy", "package.xml declares rclpy")
def declares_rclpy(recording: Recording) -> None:
    expect_dependency(recording, PACKAGE, "rclpy")


@print_forever.check("interrupt", "Ctrl+C ends it cleanly", needs="starts")
def interrupt(recording: Recording) -> None:
    expect_clean_interrupt(recording, NODE)
