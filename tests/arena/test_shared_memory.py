"""Which files of /dev/shm a program and its descendants have in memory."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from course.arena.process import files_in_memory

from .conftest import WAIT, Stage

MAPS = """
import mmap, os, subprocess, sys
name = sys.argv[1]
with open(f"/dev/shm/{name}", "w+b") as file:
    file.truncate(4096)
    kept = mmap.mmap(file.fileno(), 4096)
if len(sys.argv) > 2:
    os.remove(f"/dev/shm/{name}")
    below = subprocess.Popen([sys.executable, "-S", "-c", open(__file__).read(), sys.argv[2]])
print("mapped", flush=True)
sys.stdin.read()
"""


@pytest.fixture
def name() -> Iterator[str]:
    names = [f"ros2course-test-{os.getpid()}-{part}" for part in ("one", "below")]
    yield names[0]
    for each in names:
        Path("/dev/shm", each).unlink(missing_ok=True)


def test_files_of_a_program_and_of_what_it_has_started(stage: Stage, name: str, tmp_path: Path) -> None:
    """Even files that were removed since, which a program may do right away."""
    program = tmp_path / "maps.py"
    program.write_text(MAPS.replace("open(__file__).read()", repr(MAPS)))
    below = name.replace("one", "below")
    process = stage.start(sys.executable, "-S", str(program), name, below)
    assert stage.timeline.wait_until(lambda: stage.lines.count("mapped") == 2, WAIT), stage.lines
    assert files_in_memory(process.pid) == (below, name)


def test_a_program_that_uses_none(stage: Stage) -> None:
    process = stage.python("print('up', flush=True)\nimport sys\nsys.stdin.read()")
    stage.await_line("up")
    assert files_in_memory(process.pid) == ()


def test_a_program_that_has_ended(stage: Stage) -> None:
    process = stage.python("pass")
    process.wait(WAIT)
    assert files_in_memory(process.pid) == ()
