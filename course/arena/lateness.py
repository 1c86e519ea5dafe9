"""Measures how late this machine lets programs run, for checks that judge when something happened.

A separate process measures it, see `lateness_program`: in ours, a submission that sends a lot could delay
any thread. Delays that the submission itself causes by keeping the machine busy do not count.
"""

from __future__ import annotations

import contextlib
import json
import os
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import IO, Any

from course.arena.lateness_program import OWN_DOING
from course.evidence.timeline import Timeline
from course.model.events import Late, Watched
from course.model.feedback import Spoilt

_PROGRAM = Path(__file__).with_name("lateness_program.py")


class Lateness:
    """The measurements since the start. worst: the longest delay (s) up to the last request."""

    def __init__(self, asking: IO[bytes], answers: IO[bytes], timeline: Timeline) -> None:
        self.worst = 0.0
        self._asking = asking
        self._answers = answers
        self._timeline = timeline

    @contextlib.contextmanager
    def noted(self) -> Iterator[None]:
        """Inside this context, record each delay on the time line, and how long a program had to wait."""
        self._ask()
        self._timeline.add(Watched(self._timeline.now(), True))
        try:
            yield
        finally:
            told = self._ask()
            for moment, seconds in told["late"]:
                self._timeline.add(Late(self._timeline.at(moment), seconds))
            # Programs that keep the machine busy wait for each other.
            waited = 0.0 if told["used"] >= OWN_DOING else told["waited"]
            self._timeline.add(Watched(self._timeline.now(), False, waited))

    def update(self) -> float:
        """Return the worst delay so far (s)."""
        self._ask()
        return self.worst

    def _ask(self) -> dict[str, Any]:
        try:
            self._asking.write(b"\n")
            told: dict[str, Any] = json.loads(self._answers.readline())
        except (OSError, ValueError) as error:
            raise Spoilt("The process that measures how busy this machine is has ended.") from error
        self.worst = max([self.worst, *(seconds for _, seconds in told["late"])])
        return told


@contextlib.contextmanager
def measured_lateness(timeline: Timeline, groups: Sequence[Path] = ()) -> Iterator[Lateness]:
    """Measure in a separate process until the context ends. groups: the submission's control groups."""
    command = (sys.executable, "-I", "-S", str(_PROGRAM), str(os.getpid()), *map(str, groups))
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0) as process:
        assert process.stdin is not None and process.stdout is not None
        try:
            yield Lateness(process.stdin, process.stdout, timeline)
        finally:
            process.kill()
