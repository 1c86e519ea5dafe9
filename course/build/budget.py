"""What all builds of one check may take together, and the disk space that is reserved for them.

    ROOT/claims.lock    held while somebody claims room
    ROOT/<any>.claim    how many bytes a running build may still write; held by the process that claimed them

A submission that fills the disk would end the builds of everyone else. So each check claims what it may write
before it builds anything, old builds make room for it, and RESERVE stays free for what is written elsewhere.
"""

from __future__ import annotations

import os
import tempfile
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from course.build.runner import Interrupt
from course.build.store import Store, storage
from course.files import locked, try_lock
from course.isolation.isolation_plan import BUILD

_MB = 1024 * 1024
RESERVE = 512 * _MB
# The most that a build of the course needs. If less than this is left, a check waits for the others.
ENOUGH = 128 * _MB
_ASK_AGAIN_SECONDS = 0.2

# Which bound was reached. NO_ROOM is the machine's fault: the disk had less than a submission may take.
ALL_SECONDS, ALL_CPU, ALL_DISK, NO_ROOM = "all-time", "all-cpu", "all-disk", "no-room"
_NEVER = float("inf")


@dataclass(frozen=True)
class Bounds:
    """packages: how many. seconds: of building, added up even for packages that are built at the same time.

    cpu: seconds of computing. disk: bytes of all entries, with sources, logs and what was built before.
    """

    packages: float
    seconds: float
    cpu: float
    disk: float


SUBMISSION = Bounds(packages=30, seconds=900.0, cpu=1200.0, disk=512 * _MB)
# The course's own packages are trusted to end.
OURS = Bounds(_NEVER, _NEVER, _NEVER, _NEVER)


@dataclass(frozen=True)
class Spent:
    """What one run of a build has taken so far."""

    seconds: float
    cpu: float
    disk: int


class Budget:
    """Adds up what the builds of one check take; several threads may spend it.

    room: bytes that may be written, if the disk has less than the bounds allow. again: whether this is the
    second try, after the disk was full. insists: whether it needs all that the bounds allow.
    """

    def __init__(self, bounds: Bounds) -> None:
        self.bounds = bounds
        self.room = _NEVER
        self.again = self.insists = False
        self._lock = threading.Lock()
        self._runs: dict[object, Spent] = {}
        self._built: dict[str, int] = {}
        self._found: dict[str, int] = {}

    def begin_again(self) -> None:
        """Start the second try. Time that was spent stays spent."""
        self.again, self.insists = True, self._reached() == NO_ROOM
        self._built.clear()
        self._found.clear()
        self.room = _NEVER

    def found(self, package: str, size: int) -> None:
        """Count the bytes of a package that was built before."""
        self._found[package] = size

    def wrote(self, package: str, size: int) -> str | None:
        """Note the bytes that a package's build takes now; returns the reached bound, if any."""
        with self._lock:
            self._built[package] = size
            return self._reached()

    def spend(self, run: object, package: str, spent: Spent) -> str | None:
        """Note what a run of a package's build has taken so far; returns the reached bound, if any."""
        with self._lock:
            self._runs[run] = spent
            self._built[package] = spent.disk
            return self._reached()

    def _reached(self) -> str | None:
        if sum(spent.seconds for spent in self._runs.values()) > self.bounds.seconds:
            return ALL_SECONDS
        if sum(spent.cpu for spent in self._runs.values()) > self.bounds.cpu:
            return ALL_CPU
        new = sum(self._built.values())
        if sum(self._found.values()) + new > self.bounds.disk:
            return ALL_DISK
        return NO_ROOM if new > self.room else None


@contextmanager
def claimed(
    store: Store, budget: Budget, interrupt: Interrupt, on_wait: Callable[[], None]
) -> Iterator[None]:
    """Reserve room in the store for what the budget allows; sets `budget.room` if there is less.

    Waits while others have claimed all there is; `on_wait` is called once if that takes a while.
    """
    told, wanted = False, int(min(budget.bounds.disk, BUILD.scratch))
    enough = wanted if budget.insists else min(wanted, ENOUGH)
    with storage(store.root):
        store.root.mkdir(parents=True, exist_ok=True)
        while (claim := _claim(store, wanted, enough)) is None:
            if not told:
                on_wait()
                told = True
            interrupt.wait(_ASK_AGAIN_SECONDS)
    file, descriptor, room = claim
    if room < wanted and budget.bounds is not OURS:
        budget.room = room
    try:
        yield
    finally:
        file.unlink(missing_ok=True)
        os.close(descriptor)


def _claim(store: Store, wanted: int, enough: int) -> tuple[Path, int, int] | None:
    with locked(store.root / "claims.lock"):
        others = sum(_claims(store.root))
        store.make_room(others + wanted + RESERVE)
        free = store.free()
        room = max(0, free - min(RESERVE, free // 2) - others)
        if others and room < enough:
            return None
        return _write_claim(store.root, min(wanted, room))


def _write_claim(root: Path, room: int) -> tuple[Path, int, int]:
    descriptor, name = tempfile.mkstemp(".claim", "", root)
    try_lock(descriptor)
    os.write(descriptor, b"%d" % room)
    return Path(name), descriptor, room


def _claims(root: Path) -> Iterator[int]:
    """The claims of running builds (bytes). Files that other builds left behind are removed."""
    for file in root.glob("*.claim"):
        with suppress(OSError, ValueError), file.open("rb") as claim:
            if try_lock(claim.fileno(), shared=True):
                file.unlink(missing_ok=True)
            else:
                yield int(claim.read())
