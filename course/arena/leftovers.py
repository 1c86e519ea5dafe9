"""Nothing survives: processes that left their group or their parent are found and ended."""

from __future__ import annotations

import contextlib
import ctypes
import os

import psutil

_PR_SET_CHILD_SUBREAPER = 36
_ROUNDS = 50


def adopt_orphans() -> None:
    """From now on, processes whose parent dies become children of this process.

    So a daemon that a learner's node forked off cannot get out of sight. Source: prctl(2).
    """
    ctypes.CDLL(None, use_errno=True).prctl(_PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)


def end_descendants() -> int:
    """Kill every process below this one, again and again until none is left.

    Returns how many were still there (0 when everyone had ended in order).
    """
    found: set[int] = set()
    for _ in range(_ROUNDS):
        left = psutil.Process().children(recursive=True)
        if not left:
            break
        found |= {child.pid for child in left}
        for child in left:
            with contextlib.suppress(psutil.Error):
                child.kill()
        psutil.wait_procs(left, timeout=0.5)
        for child in left:
            _reap(child.pid)
    return len(found)


def _reap(pid: int) -> None:
    """An adopted orphan stays a zombie until its new parent, us, takes note of its end."""
    with contextlib.suppress(ChildProcessError):
        os.waitpid(pid, os.WNOHANG)
