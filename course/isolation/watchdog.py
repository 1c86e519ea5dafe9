"""Notices when a submission exceeds a limit, by its control groups or by looking at its processes."""

from __future__ import annotations

import contextlib
import os
import threading
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path

import psutil

from course.isolation import identity
from course.isolation.isolation_plan import ResourceLimits

PERIOD = 0.2
# Which limit was reached.
MEMORY, PROCESSES, CPU, DISK = "memory", "processes", "cpu", "disk"
_PAGE = 4096
_MANY = 0.2


def most_of(limits: ResourceLimits, limit: str) -> float:
    """The limit for one resource: bytes, a number, or seconds."""
    known = {MEMORY: limits.memory, PROCESSES: limits.processes, CPU: limits.cpu, DISK: limits.scratch}
    return known[limit]


class Watchdog:
    """Looks when asked. root: the pid of a process of the submission. Its descendants belong to it, too, and
    so do all processes in a namespace in which it is the first.

    groups: the submission's control groups. scratch: returns how many bytes it has written, and how many it
    may write. cpu: seconds of computing at the last look.
    """

    def __init__(
        self,
        limits: ResourceLimits,
        groups: Sequence[Path],
        root: int,
        scratch: Callable[[], tuple[int, int]],
    ) -> None:
        self._limits = limits
        self._groups = groups
        self._root = root
        self._scratch = scratch
        self.cpu = 0.0

    def look(self) -> str | None:
        """The limit that has been reached, or None."""
        used, most = self._scratch()
        if used >= most:
            return DISK
        return self._by_groups() if self._groups else self._by_processes()

    def _by_groups(self) -> str | None:
        self.cpu = identity.cpu_seconds(self._groups)
        # Checked first, because too many processes also use up the memory.
        if identity.refused_processes(self._groups):
            return PROCESSES
        if identity.memory_kills(self._groups):
            return MEMORY
        return CPU if self.cpu > self._limits.cpu else None

    def _by_processes(self) -> str | None:
        memory, threads, seconds = 0, 0, 0.0
        for process in _tree(self._root):
            with contextlib.suppress(psutil.Error):
                memory += process.memory_info().rss
                threads += process.num_threads()
                seconds += sum(process.cpu_times()[:4])
        self.cpu = seconds
        if threads >= self._limits.processes:  # the kernel refuses anything far beyond
            return PROCESSES
        if memory > self._limits.memory:
            # Shared memory is counted once per process, so with many processes the sum says nothing.
            return PROCESSES if threads >= self._limits.processes * _MANY else MEMORY
        return CPU if seconds > self._limits.cpu else None


@contextlib.contextmanager
def watching(watchdog: Watchdog, on_breach: Callable[[str], None]) -> Iterator[Callable[[], None]]:
    """Look in a separate thread; call `on_breach` once. Yields a function that looks now, in any thread."""
    over, one_at_a_time = threading.Event(), threading.Lock()

    def look() -> None:
        with one_at_a_time:
            breach = None if over.is_set() else watchdog.look()
            if breach is not None:
                over.set()
                on_breach(breach)

    def watch() -> None:
        while not over.wait(PERIOD):
            look()

    thread = threading.Thread(target=watch, name="watchdog", daemon=True)
    thread.start()
    try:
        yield look
    finally:
        look()  # a limit may be why a program ended or did not start
        over.set()
        thread.join()


def filesystem(folder: Path, further: Sequence[Path] = ()) -> Callable[[], tuple[int, int]]:
    """For a submission with its own file system: it has written too much when that is full.

    Each file counts as at least one page, because even empty files use the kernel's memory. further: other
    file systems, of which only the number of files counts.
    """

    def used() -> tuple[int, int]:
        status = os.statvfs(folder)
        size = status.f_blocks * status.f_frsize
        taken = size - status.f_bavail * status.f_frsize
        return max(taken + _PAGE, _PAGE * sum(map(_files, (folder, *further)))), size

    return used


def _files(folder: Path) -> int:
    try:
        status = os.statvfs(folder)
    except OSError:  # not visible from here, or gone
        return 0
    return status.f_files - status.f_ffree


def _tree(root: int) -> Iterable[psutil.Process]:
    """All processes below that one, and others in its namespace, where programs are put from outside."""
    found: dict[int, psutil.Process] = {}
    with contextlib.suppress(psutil.Error):
        top = psutil.Process(root)
        found.update((process.pid, process) for process in (top, *top.children(recursive=True)))
        namespace = _namespace(root)
        if namespace not in (None, _namespace(os.getpid())):
            every = psutil.process_iter()
            found.update((process.pid, process) for process in every if _namespace(process.pid) == namespace)
    return found.values()


def _namespace(pid: int) -> str | None:
    try:
        return os.readlink(f"/proc/{pid}/ns/pid")  # noqa: PTH115 - it leads to no file
    except OSError:
        return None
