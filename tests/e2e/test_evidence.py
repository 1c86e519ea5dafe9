"""A real recording: drawn by `check --timeline` and `evidence show`, exported, and read by other programs."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
from rosbags.highlevel import AnyReader

from course.content import open_course
from course.grading import trial

from .conftest import Run

pytestmark = pytest.mark.slow

EXERCISE = "18-publisher"
QUOTE = "package_with_interfaces/msg/AmazingQuote"
EVENTS = "/ros2course/events"


def laid(run: Run, home: Path, mistake: str = "") -> None:
    course = open_course()
    exercise = course.exercise(EXERCISE)
    run("next", EXERCISE)
    trial.lay_solution(course, exercise, home)
    if mistake:
        found = next(one for one in exercise.mistakes() if one.id == mistake)
        trial.apply_mistake(exercise, found, home)


def words(text: str) -> str:
    return " ".join(text.split())


def test_a_right_publisher(run: Run, course_home: Path, guarded_home: Path) -> None:
    laid(run, course_home)
    checked = run("check", "--timeline")
    assert checked.returncode == 0, checked.stdout + checked.stderr
    shown = run("evidence", "show", EXERCISE)
    for drawn in (checked.stdout, shown.stdout):
        assert "Expected one every 0.40 s to 0.60 s." in words(drawn)
        assert "expected 0.4 to 0.6 s (the median)" in drawn
        assert "/amazing_quote_publisher_node ─→ /amazing_quote ─→ the grader" in words(drawn)
        assert max(map(len, drawn.splitlines())) <= 80 and "\x1b" not in drawn
    assert run("evidence", "export", "--to", "quotes.mcap").returncode == 0
    read_by_others(guarded_home / "quotes.mcap")


def test_a_topic_with_a_slip(run: Run, course_home: Path) -> None:
    laid(run, course_home, "publisher-topic-plural")
    checked = run("check", "--timeline")
    assert checked.returncode == 1, checked.stdout + checked.stderr
    drawn = words(checked.stdout)
    assert "! nobody ─→ /amazing_quote ─→ the grader" in drawn
    assert "! /amazing_quote_publisher_node ─→ /amazing_quotes ─→ nobody" in drawn


def read_by_others(file: Path) -> None:
    with file.open("rb") as stream:
        reader = make_reader(stream, validate_crcs=True, decoder_factories=[DecoderFactory()])
        quotes = [data.id for *_, data in reader.iter_decoded_messages(topics=["/amazing_quote"])]
        told = [json.loads(data.json) for *_, data in reader.iter_decoded_messages(topics=[EVENTS])]
    assert quotes[:5] == [0, 1, 2, 3, 4]
    assert {"ProcessStarted", "GraphSeen", "Joined", "SignalSent"} <= {event["kind"] for event in told}
    with AnyReader([file]) as bag:
        read = [
            (connection.topic, connection.msgtype, bag.deserialize(data, connection.msgtype))
            for connection, _, data in bag.messages()
        ]
    assert [message.id for topic, kind, message in read if kind == QUOTE] == quotes
    assert len([message for topic, _, message in read if topic == EVENTS]) == len(told)
