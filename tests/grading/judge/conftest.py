"""Stored recordings of a small course whose graders are any Python text."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.content import Exercise, open_course
from course.evidence.mcap_file import save
from course.evidence.recording import Recording
from course.grading.judge.judges import StoredRecording, rejudge
from course.grading.protocol import Judged, Unjudged
from course.model.events import Event

GRADER = """
import os, signal, sys
import pytest
from course.api import Failure, Feedback, Grader, expect_period

LONG = 5
light = Grader("04-light", builds=None)
dim = Grader("04-dim", builds=None)

@light.scenario
def shine(arena):
    arena.run("lanterns", "light")

@light.check("long", "it shines long", points=2)
def long(recording):
    if recording.duration < LONG:
        raise Failure(Feedback(f"It shone {recording.duration:g} s."))

@light.check("bright", "it is bright", needs="long")
def bright(recording):
    pass

@dim.check("dim", "it is dim")
def is_dim(recording):
    pass
"""

Store = Callable[..., StoredRecording[str]]


@pytest.fixture
def grader(small_course: Path) -> Path:
    file = small_course / "graders/ch04_lanterns.py"
    file.write_text(GRADER)
    return file


@pytest.fixture
def light(grader: Path) -> Exercise:
    return open_course(grader.parents[1]).exercise("04-light")


@pytest.fixture
def store(grader: Path, tmp_path: Path) -> Store:
    """Write a recording to a separate file, and return its path."""

    def stored(
        key: str,
        seconds: float,
        exercise: str = "04-light",
        scenario: str = "",
        events: tuple[Event, ...] = (),
    ) -> StoredRecording[str]:
        file = tmp_path / f"{key}.mcap"
        save(Recording(exercise, events, duration=seconds, scenario=scenario), file, began_ns=0)
        return StoredRecording(key, open_course(grader.parents[1]).exercise(exercise), file)

    return stored


def judged(*recordings: StoredRecording[str], jobs: int = 1) -> dict[str, Judged | Unjudged]:
    return dict(rejudge(recordings, jobs=jobs))


def outcomes(answer: Judged | Unjudged) -> list[str]:
    assert isinstance(answer, Judged), answer
    assert answer.judgment.fault is None
    return [check.outcome.value for check in answer.judgment.checks]
