"""Asks the learner's Python code questions, in a separate process.

The probe's code is ours: it imports the learner's module and asks, `ask("sum", lambda: f(1, 2))`. Answers
come over a separate pipe, so the output of the learner's code does no harm.
"""

from __future__ import annotations

import json
import os
import select
import time
from collections.abc import Callable, Mapping
from pathlib import Path

from course.arena.process import Process
from course.errors import OurFault
from course.evidence.timeline import Timeline
from course.model.events import Probed

PROBE_TIME = 10.0
START_TIME = 30.0
MAX_ANSWERS = 1024 * 1024
_PROGRAM = Path(__file__).with_name("probe_program.py")
_CHUNK = 65536
_GRACE = 1.0
_DONE = "done"
_TEXT: tuple[type, ...] = (str, type(None))
_FIELDS: Mapping[str, type | tuple[type, ...]] = {
    "question": str,
    "type": str,
    "error": _TEXT,
    "file": _TEXT,
    "line": (int, type(None)),
}
# Values from `probe_program.plain` are never this deep.
_MAX_DEPTH = 10

# Starts a command under the probe's name, with the descriptor for its answers.
Launch = Callable[[tuple[str, ...], tuple[int, ...]], Process]


def run_probe(
    launch: Launch, python: str, code: Path, home: Path, timeline: Timeline, name: str, timeout: float
) -> None:
    """Run the probe in the file `code`, and record its answers when it ends or its time is up."""

    def start(writing: int) -> Process:
        return launch((python, str(_PROGRAM), str(writing), str(code), str(home)), (writing,))

    if not collect_answers(start, timeline, name, timeout, START_TIME):
        raise OurFault(f"the probe {name} did not start")


def collect_answers(
    start: Callable[[int], Process], timeline: Timeline, name: str, timeout: float, start_time: float
) -> bool:
    """Start a program with a descriptor for answers, and record them when it ends; True if there were any.

    start_time: seconds until the first one; after that, it has `timeout` s for the others.
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
    process.wait(_GRACE)  # for its last output, but not for threads that their code left behind
    process.close()
    *lines, _ = data.decode("utf-8", errors="replace").split("\n")
    answers = tuple(line for line in lines if _is_answer(line))
    timeline.add(Probed(timeline.now(), name, answers, json.dumps(_DONE) in lines))
    return bool(data)


def _read(descriptor: int, start_time: float, timeout: float) -> bytes:
    """Read until all holders of the pipe have closed it, the time is up, or there is too much.

    The learner's time starts when Python has started, which takes a while on a busy machine.
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
    """The learner's code runs in the same process and may also write to the pipe."""
    try:
        data = json.loads(line)
        json.dumps(data, ensure_ascii=False).encode()  # fails for a lone surrogate
    except (ValueError, RecursionError):
        return False
    if not isinstance(data, dict) or "question" not in data:
        return False
    value = data.pop("value", None)
    plain = all(name in _FIELDS and isinstance(found, _FIELDS[name]) for name, found in data.items())
    return plain and _is_shallow(value, _MAX_DEPTH)


def _is_shallow(value: object, depth: int) -> bool:
    inner = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    return depth > 0 and all(_is_shallow(item, depth - 1) for item in inner)
