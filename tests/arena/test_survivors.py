"""Processes that a program leaves running."""

from __future__ import annotations

import os
import signal
import subprocess
import sys

import pytest

from course.arena.process import started_by, still_there

from .conftest import ended

PARENT = (
    "import subprocess, sys\n"
    "child = subprocess.Popen(['sleep', '100'], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)\n"
    "print(child.pid, flush=True)\n"
    "sys.stdin.read()\n"
)


@pytest.mark.slow
def test_a_child_that_outlives_its_parent() -> None:
    with subprocess.Popen(
        [sys.executable, "-S", "-c", PARENT], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as parent:
        pid = int(parent.stdout.readline())
        below = started_by(parent.pid)
        assert [one.pid for one in below] == [pid]
        parent.communicate()
    assert still_there(below) == ((pid, ("sleep", "100")),)
    os.kill(pid, signal.SIGKILL)
    assert ended(pid)
    assert still_there(below) == ()


def test_of_a_process_that_is_gone() -> None:
    with subprocess.Popen(["true"]) as gone:
        gone.wait()
    assert started_by(gone.pid) == ()
    assert still_there(()) == ()
