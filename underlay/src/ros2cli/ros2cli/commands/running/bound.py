"""A process that dies with the one that started it, even if that is killed."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable

_PR_SET_PDEATHSIG = 1


def binding() -> Callable[[], None]:
    """Return what a child is to call after the fork: Linux then kills it when this process ends."""
    import ctypes

    libc, parent = ctypes.CDLL(None), os.getpid()

    def bind() -> None:
        if hasattr(libc, "prctl"):
            libc.prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
        if os.getppid() != parent:  # it ended before we asked
            os.kill(os.getpid(), signal.SIGKILL)

    return bind
