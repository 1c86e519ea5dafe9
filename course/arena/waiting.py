"""How long threads of programs had to wait for a processor, by what the kernel counts."""

from __future__ import annotations

import contextlib
from collections.abc import Mapping
from pathlib import Path

import psutil


def waited_below() -> Mapping[int, float]:
    """By thread, of all processes that this one or one of them has started, the seconds so far.

    Empty where the kernel does not tell.
    """
    with contextlib.suppress(psutil.Error):
        below = psutil.Process().children(recursive=True)
        return {thread: seconds for process in below for thread, seconds in _of_threads(process.pid)}
    return {}


def longest(before: Mapping[int, float], after: Mapping[int, float]) -> float:
    """The seconds that were added to one thread's; one that began in between has waited from then on."""
    added = (seconds - before.get(thread, 0.0) for thread, seconds in after.items())
    return round(max(added, default=0.0), 6)


def _of_threads(pid: int) -> list[tuple[int, float]]:
    found = []
    with contextlib.suppress(OSError):  # it has ended
        for thread in Path(f"/proc/{pid}/task").iterdir():
            with contextlib.suppress(OSError, IndexError, ValueError):
                _, waited, *_ = (thread / "schedstat").read_text(encoding="ascii").split()
                found.append((int(thread.name), int(waited) / 1e9))
    return found
