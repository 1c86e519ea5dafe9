"""Ends what a killed launch leaves behind: a process beside it, which is there from the first process on."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
from pathlib import Path

_PROGRAM = Path(__file__).with_name("guard_program.py")
_ALL_IS_WELL = "end\n"


class Guard:
    """Waits for the end of the launch, however that comes.

    Every process inherits the end of a pipe, the mark: so the guard knows those, too, that were being
    started when the launch was killed, and what they have started in turn.
    """

    def __init__(self) -> None:
        self._process: subprocess.Popen[bytes] | None = None
        self._mark = -1

    def mark(self) -> int:
        """The file descriptor that a process is to inherit; from now on the guard is there."""
        if self._process is None:
            reading, self._mark = os.pipe()
            os.close(reading)
            self._process = _started(os.fstat(self._mark).st_ino)
        return self._mark

    def watch(self, pid: int) -> None:
        """A process that may close what it has inherited is known by its number."""
        self._tell(f"+{pid}\n")

    def forget(self, pid: int) -> None:
        """It has ended: its number may be another's soon."""
        self._tell(f"-{pid}\n")

    def close(self) -> None:
        """The launch has ended as it should: what still runs is meant to."""
        if self._process is not None:
            self._tell(_ALL_IS_WELL)
            self._process.communicate()
            self._process = None
            os.close(self._mark)

    def _tell(self, text: str) -> None:
        if self._process is not None and self._process.stdin is not None:
            with contextlib.suppress(BrokenPipeError):
                self._process.stdin.write(text.encode())
                self._process.stdin.flush()


def _started(mark: int) -> subprocess.Popen[bytes]:
    """In a session of its own: what the terminal sends is not meant for it."""
    return subprocess.Popen(
        [sys.executable, "-I", "-S", str(_PROGRAM), str(mark)],
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        cwd="/",
        start_new_session=True,
    )
