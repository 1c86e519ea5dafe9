"""No isolation: programs are our children, and any processes that they leave behind are found and ended.

For our own programs, for tests, and for machines without namespaces. See `course.isolation.Backend`.
"""

from __future__ import annotations

import contextlib
import ctypes
import os
import signal
import subprocess
from collections.abc import Collection, Iterator, Sequence
from pathlib import Path
from typing import Any, NoReturn

import psutil

from course.errors import OurFault
from course.isolation.isolation_plan import IsolatedProcess, IsolationPlan, Level

_PR_SET_CHILD_SUBREAPER = 36
_ROUNDS = 50


def obstacle(level: Level) -> str | None:
    return None if level is Level.DOMAIN else "there is no isolation"


def prefix(plan: IsolationPlan | None) -> tuple[str, ...]:
    """Nothing is put in front of a command."""
    return ()


@contextlib.contextmanager
def start(plan: IsolationPlan | None, command: Sequence[str], **options: Any) -> Iterator[IsolatedProcess]:
    """See `isolation.start`."""
    process = subprocess.Popen(command, start_new_session=True, **options)
    try:
        yield IsolatedProcess(process)
    finally:
        end(process)


def end(process: subprocess.Popen[bytes]) -> None:
    """Kill the rest of the process's session, unless its end was already noted."""
    # Until the leader is reaped, nobody else can have its number.
    if process.returncode is None:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    for stream in (process.stdin, process.stdout, process.stderr):
        if stream:
            with contextlib.suppress(OSError):  # output that was not written yet
                stream.close()


def program() -> str:
    """Nothing can change."""
    return ""


def build_obstacle() -> str | None:
    return "there is no isolation"


def restriction() -> None:
    """No setting would help."""


def with_own_memory(command: Sequence[str]) -> tuple[str, ...]:
    raise OurFault("without isolation there is no memory of its own")


def hold(plan: IsolationPlan, scratch: Path | None = None) -> NoReturn:
    raise OurFault("without isolation there are no namespaces to hold")


def adopt_orphans(adopt: bool = True) -> None:
    """From now on, processes whose parent dies become children of this process (or no longer do).

    So a daemon that a learner's node forked cannot escape. Source: prctl(2).
    """
    ctypes.CDLL(None, use_errno=True).prctl(_PR_SET_CHILD_SUBREAPER, int(adopt), 0, 0, 0)


@contextlib.contextmanager
def nothing_left() -> Iterator[None]:
    """End whatever started below this process in the meantime, including orphans, with the context."""
    spared = frozenset(psutil.Process().children())
    adopt_orphans()
    try:
        yield
    finally:
        end_descendants(spared)
        adopt_orphans(False)


def end_descendants(spared: Collection[psutil.Process] = ()) -> int:
    """Kill every process below this one, again and again until none is left.

    spared: children that are left alone, with everything below them.
    Returns how many were still there (0 if all had ended by themselves).
    """
    found: set[int] = set()
    numbers = {child.pid for child in spared}
    for _ in range(_ROUNDS):
        found |= _strike(numbers)
        left = _descendants(spared)
        if not left:
            break
        found |= {child.pid for child in left if _alive(child)}
        for child in left:
            with contextlib.suppress(psutil.Error):
                child.kill()
        psutil.wait_procs(left, timeout=0.5)
        for child in left:
            _reap(child.pid)
    return len(found)


def _strike(spared: Collection[int]) -> set[int]:
    """Kill those that exist at this moment; return those that were still alive.

    A process may fork and end before a look at all processes is over.
    """
    struck, waiting = set(), _children(os.getpid())
    while waiting:
        pid = waiting.pop()
        if pid not in spared:
            with contextlib.suppress(OSError):  # it has ended
                if _state(pid) != "Z":
                    os.kill(pid, signal.SIGKILL)
                    struck.add(pid)
            waiting += _children(pid)  # once killed, it starts no more children
    return struck


def _children(pid: int) -> list[int]:
    """Its direct children, as the kernel lists them at this moment; none if the kernel has no such list."""
    found: list[int] = []
    with contextlib.suppress(OSError):
        for thread in Path(f"/proc/{pid}/task").iterdir():
            found += map(int, (thread / "children").read_text(encoding="ascii").split())
    return found


def _state(pid: int) -> str:
    return Path(f"/proc/{pid}/stat").read_bytes().rpartition(b")")[2].split()[0].decode()


def _descendants(spared: Collection[psutil.Process]) -> list[psutil.Process]:
    kept = set(spared)
    for child in spared:
        with contextlib.suppress(psutil.NoSuchProcess):
            kept.update(child.children(recursive=True))
    # One look at all processes, however many there are: they may be multiplying.
    return [child for child in psutil.Process().children(recursive=True) if child not in kept]


def _alive(process: psutil.Process) -> bool:
    try:
        return process.status() != psutil.STATUS_ZOMBIE
    except psutil.NoSuchProcess:
        return False


def _reap(pid: int) -> None:
    """An adopted orphan stays a zombie until its new parent, this process, reaps it."""
    with contextlib.suppress(ChildProcessError):
        os.waitpid(pid, os.WNOHANG)
