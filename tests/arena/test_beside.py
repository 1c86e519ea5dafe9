"""What a scenario does besides running the learner's programs: it keeps time, and plays along."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from course.arena.arena import Arena, open_arena
from course.arena.home_programs import Surroundings
from course.evidence.packages import BuiltPackages
from course.evidence.recording import Recording
from course.evidence.timeline import Timeline

from .conftest import WAIT


@pytest.fixture
def arena(tmp_path: Path) -> Iterator[Arena]:
    ours = tmp_path / "ours"
    ours.mkdir()
    given = Surroundings({}, sys.executable, tmp_path / "programs", ours=ours)
    with open_arena(Timeline(), BuiltPackages(), given, ros=False) as one:
        yield one


def test_ticks_come_when_they_are_due_and_none_is_left_out(arena: Arena) -> None:
    began = time.monotonic()
    late = [time.monotonic() - began - 0.01 * number for number in arena.ticks(0.01, 5)]
    assert len(late) == 5
    assert min(late) >= 0


def test_a_program_of_ours_has_our_environment_and_a_log_that_is_in_nobodys_way(
    arena: Arena, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("OF_OURS", "yes")
    file = tmp_path / "robot.py"
    file.write_text("import os, sys\nprint(os.environ['OF_OURS'], os.environ['ROS_LOG_DIR'], sys.argv[1])\n")
    assert arena.play_along(file, "arm", name="robot").wait(WAIT)
    said = Recording("x", arena.timeline.events()).process("robot").text
    assert said == (f"yes {tmp_path}/ours/log arm",)
