"""The program of the guard: told of processes on its input, it kills what is left of them at its end.

It runs by itself, as a script, with nothing but the standard library. Its argument is the number of the pipe
that the processes of the launch hold. `+pid` and `-pid` are processes that came and went; `end` says that
the launch has ended as it should.
"""

from __future__ import annotations

import os
import signal
import sys
import time
from collections.abc import Iterable

sys.path.insert(0, os.path.dirname(__file__))  # noqa: PTH120  as in tree.py

from tree import descendants, holders

_ROUNDS = 200  # what is killed may have started something a moment before
_SHORT, _LONG = 0.02, 0.2  # seconds from one look to the next, longer and longer while nothing is found
_QUIET = 1.0  # seconds without a find; a process that becomes another program cannot be looked into meanwhile


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
    pause, quiet = _SHORT, 0.0
    for _ in range(_ROUNDS):
        left = holders(mark)
        _kill([*descendants(left), *left])
        if quiet >= _QUIET and not left:
            return
        pause, quiet = (_SHORT, 0.0) if left else (min(2 * pause, _LONG), quiet)
        time.sleep(pause)
        quiet += pause


def _kill(pids: Iterable[int]) -> None:
    for pid in pids:
        try:  # noqa: SIM105  as in tree.py
            os.kill(pid, signal.SIGKILL)
        except (ProcessLookupError, PermissionError):
            pass


if __name__ == "__main__":
    main()
