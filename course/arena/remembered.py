"""What was found to work on this machine is not tried again before each check.

Kept until the machine starts anew or bubblewrap changes. Only success is kept: who has just installed or
allowed something shall see it at once.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Callable
from pathlib import Path

from course.rosenv import cache_dir
from course.rosenv.files import write_atomic

_BOOT = Path("/proc/sys/kernel/random/boot_id")


def unless_known(name: str, program: str, obstacle: Callable[[], str | None]) -> str | None:
    """What `obstacle()` says, which is asked only if it is not known that there is none."""
    file = cache_dir(os.environ) / "known" / name
    stamp = _stamp(program)
    with contextlib.suppress(OSError, UnicodeDecodeError):
        if stamp and file.read_text(encoding="utf-8") == stamp:
            return None
    found = obstacle()
    if found is None and stamp:
        with contextlib.suppress(OSError):  # then it is tried again next time
            write_atomic(file, stamp)
    return found


def forget(name: str) -> None:
    """It did not work after all."""
    with contextlib.suppress(OSError):
        (cache_dir(os.environ) / "known" / name).unlink()


def _stamp(program: str) -> str | None:
    try:
        status = Path(program).stat()
        boot = _BOOT.read_text(encoding="ascii").strip()
    except OSError:
        return None
    return f"{boot} {os.geteuid()} {program} {status.st_mtime_ns} {status.st_size}"
