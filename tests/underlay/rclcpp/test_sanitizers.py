"""No leak, no use of what is gone, no undefined behaviour and no data race in a node that does everything."""

from __future__ import annotations

import signal
import subprocess
from pathlib import Path

import pytest

from course.rosenv import find_ros
from tests.underlay.rclcpp.room import SOURCES, Room

pytestmark = pytest.mark.slow
_PROJECT = Path(__file__).with_name("sanitized")
_SECONDS = 60.0
_OPTIONS = {
    "ASAN_OPTIONS": "detect_leaks=1",
    "UBSAN_OPTIONS": "print_stacktrace=1",
    # What the libraries of the wheels do among themselves is not looked at: they are not compiled for it.
    "TSAN_OPTIONS": "ignore_noninstrumented_modules=1",
}


@pytest.mark.parametrize("sanitizer", ["address,undefined", "thread"])
def test_a_busy_node(sanitizer: str, room: Room) -> None:
    configure = ["cmake", "-S", _PROJECT, "-B", "build", f"-DRCLCPP={SOURCES}", f"-DSANITIZE={sanitizer}"]
    configure.append(f"-DPython3_EXECUTABLE={find_ros().python}")
    for command in (configure, ["cmake", "--build", "build"]):
        done = subprocess.run(
            command, cwd=room.folder, env=room.environment, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stdout + done.stderr
    busy = [room.folder / "build" / "busy"]
    with subprocess.Popen(
        busy,
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
    assert "Sanitizer" not in said
    assert said.splitlines()[-1] == "characters 1 answers 1 changes 1 passed 1"
