"""What a program started, and what of it is still there after the program's end."""

from __future__ import annotations

import psutil

_SETTLING = 0.5


def started_by(pid: int) -> tuple[psutil.Process, ...]:
    """All processes below this one, as they are now."""
    try:
        return tuple(psutil.Process(pid).children(recursive=True))
    except psutil.NoSuchProcess:
        return ()


def still_there(processes: tuple[psutil.Process, ...]) -> tuple[tuple[int, tuple[str, ...]], ...]:
    """Pid and command of those that still run; one that is just ending is given a moment."""
    _, alive = psutil.wait_procs([one for one in processes if _runs(one)], timeout=_SETTLING)
    found = ((one.pid, _command(one)) for one in alive if _runs(one))
    return tuple((pid, command) for pid, command in found if command)


def _runs(process: psutil.Process) -> bool:
    try:
        return process.is_running() and process.status() != psutil.STATUS_ZOMBIE
    except psutil.NoSuchProcess:
        return False


def _command(process: psutil.Process) -> tuple[str, ...]:
    try:
        return tuple(process.cmdline())
    except psutil.Error:
        return ()
