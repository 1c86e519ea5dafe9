"""Asks the learner's Python code questions of ours, in a process of its own.

The probe's code is ours: it imports the learner's module and asks, `ask("sum", lambda: f(1, 2))`. Answers
come over a pipe of their own, so whatever the learner's code prints does no harm.
"""

from __future__ import annotations

import json
import os
import select
import time
from collections.abc import Callable
from pathlib import Path

from course.arena.process import Process
from course.errors import OurFault
from course.evidence.events import Probed
from course.evidence.timeline import Timeline

PROBE_TIME = 10.0
START_TIME = 30.0
MAX_ANSWERS = 1024 * 1024
_PROGRAM = Path(__file__).with_name("probe_program.py")
_CHUNK = 65536
_GRACE = 1.0
_DONE = "done"
_FIELDS = frozenset({"question", "value", "type", "error", "file", "line"})

# Starts a command under the probe's name, with the descriptor that it writes its answers to.
Launch = Callable[[tuple[str, ...], tuple[int, ...]], Process]


def run_probe(
    launch: Launch, python: str, code: Path, home: Path, timeline: Timeline, name: str, timeout: float
) -> None:
    """Run the probe in the file `code`, and record its answers when it has ended or its time is up."""

    def start(writing: int) -> Process:
        return launch((python, str(_PROGRAM), str(writing), str(code), str(home)), (writing,))

    if not collect_answers(start, timeline, name, timeout, START_TIME):
        raise OurFault(f"the probe {name} did not start")


def collect_answers(
    start: Callable[[int], Process], timeline: Timeline, name: str, timeout: float, start_time: float
) -> bool:
    """Start a program with the descriptor to write answers to, and record them at its end; whether any came.

    start_time: seconds until the first one; then it has `timeout` s for all others.
    """
    reading, writing = os.pipe()
    try:
        try:
            process = start(writing)
        finally:
            os.close(writing)
        data = _read(reading, start_time, timeout)
    finally:
        os.close(reading)
    process.wait(_GRACE)  # what it printed last; a thread that their code left behind is not waited for
    process.close()
    *lines, _ = data.decode("utf-8", errors="replace").split("\n")
    answers = tuple(line for line in lines if _is_answer(line))
    timeline.add(Probed(timeline.now(), name, answers, json.dumps(_DONE) in lines))
    return bool(data)


def _read(descriptor: int, start_time: float, timeout: float) -> bytes:
    """Until the last holder of the pipe has closed it, the time is up, or it is too much.

    The learner's time begins when Python has started, which takes long where much else goes on.
    """
    data, deadline = b"", time.monotonic() + start_time
    while len(data) < MAX_ANSWERS:
        ready, _, _ = select.select([descriptor], [], [], max(0.0, deadline - time.monotonic()))
        if not data:
            deadline = time.monotonic() + timeout
        more = os.read(descriptor, _CHUNK) if ready else b""
        if not more:
            break
        data += more
        if data.endswith(json.dumps(_DONE).encode() + b"\n"):
            break
    return data


def _is_answer(line: str) -> bool:
    """The learner's code runs in the same process: what it may have written there is no answer of ours."""
    try:
        data = json.loads(line)
    except ValueError:
        return False
    return isinstance(data, dict) and isinstance(data.get("question"), str) and data.keys() <= _FIELDS
