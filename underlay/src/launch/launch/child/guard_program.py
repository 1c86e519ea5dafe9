"""The program of the guard: told of processes on its input, it kills what is left of them at its end.

It runs by itself, as a script, with nothing but the standard library. Its argument is the number of the pipe
that the processes of the launch hold. `+pid` and `-pid` are processes that came and went; `end` says that
the launch has ended as it should.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
import time
from collections.abc import Iterable
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from tree import descendants, holders

_ROUNDS, _PAUSE = 200, 0.02  # what is killed may have started something a moment before
_QUIET = 50  # rounds without a find; a process that becomes another program cannot be looked into meanwhile


def main() -> None:
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)
    watched: set[int] = set()
    for line in sys.stdin:
        if line == "end\n":
            return
        (watched.add if line[0] == "+" else watched.discard)(int(line[1:]))
    _end_all(watched, f"pipe:[{sys.argv[1]}]")


def _end_all(watched: set[int], mark: str) -> None:
    _kill([*descendants(watched), *watched])
    quiet = 0
    for _ in range(_ROUNDS):
        left = holders(mark)
        _kill([*descendants(left), *left])
        quiet = 0 if left else quiet + 1
        if quiet == _QUIET:
            return
        time.sleep(_PAUSE)


def _kill(pids: Iterable[int]) -> None:
    for pid in pids:
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.kill(pid, signal.SIGKILL)


if __name__ == "__main__":
    main()
