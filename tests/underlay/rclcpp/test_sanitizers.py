"""No leak, no use of what is gone, no undefined behavior and no data race in a node that does everything."""

from __future__ import annotations

import signal
import subprocess
from pathlib import Path

import pytest

from course.build import Store
from tests.underlay.rclcpp.busy import SANITIZERS, busy
from tests.underlay.rclcpp.room import Room

pytestmark = pytest.mark.slow
_SECONDS = 60.0
_OPTIONS = {
    "ASAN_OPTIONS": "detect_leaks=1",
    # What the libraries of the wheels do among themselves is not looked at: they are not compiled for it.
    "TSAN_OPTIONS": "ignore_noninstrumented_modules=1",
}


@pytest.mark.parametrize(
    ("sanitizer", "wrong", "said"),
    [
        ("address", "leak", "LeakSanitizer: detected memory leaks"),
        ("address", "undefined", "runtime error: signed integer overflow"),
        ("thread", "race", "ThreadSanitizer: data race"),
    ],
)
def test_what_is_wrong_is_found(
    sanitizer: str, wrong: str, said: str, room: Room, shared_builds: Store
) -> None:
    with room.started(busy(sanitizer, room.folder, shared_builds), wrong, **_OPTIONS) as program:
        ended = program.wait()
    assert ended.code != 0
    assert said in ended.text


@pytest.mark.parametrize("sanitizer", SANITIZERS)
def test_a_busy_node(sanitizer: str, room: Room, shared_builds: Store) -> None:
    program = busy(sanitizer, room.folder, shared_builds)
    with subprocess.Popen(
        [program],
        env={**room.environment, **_OPTIONS},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    ) as process:
        try:
            said, _ = process.communicate(timeout=_SECONDS)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGINT)
            said, _ = process.communicate(timeout=_SECONDS)
    assert process.returncode == 0, said
    first, *_, last = [line for line in said.splitlines() if not line.startswith("[")]
    # Not the usual one, which is on LD_LIBRARY_PATH.
    assert Path(first.removeprefix("rclcpp: ")).is_relative_to(program.parents[2]), first
    assert last == "characters 1 answers 1 changes 1 passed 1 results 1"
