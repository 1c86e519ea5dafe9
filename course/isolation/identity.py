"""Who a submission is on this machine: a user id that nobody else has, and its own control groups.

If this machine lets us make control groups, they limit memory, processes, and the share of CPU. Both
versions work: version 1 has one tree for each resource, version 2 has one for all.
Source: cgroups(7), and the kernel's documents on cgroup-v1 and cgroup-v2.
"""

from __future__ import annotations

import contextlib
import errno
import itertools
import os
import re
import signal
import socket
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from course.errors import MissingHere
from course.isolation.isolation_plan import ResourceLimits

ROOT = Path("/sys/fs/cgroup")
_NEEDED = ("memory", "pids")
_LEFT = re.compile(r"ros2course-(\d+)-(\d+)-\d+")
_NUMBERS = itertools.count()
_REMOVAL = 5.0
# If CPU is short, all of a submission's programs together get as much as one program outside.
_SHARES, _WEIGHT = "1024", "100"
# Far above the users of any system; for a root with only some of the ids, near the end of those.
_RANGES = (range(2_000_000_000, 2_000_010_000), range(55_000, 60_000))
_MAP = Path("/proc/self/uid_map")


@contextlib.contextmanager
def control_groups(limits: ResourceLimits, root: Path = ROOT) -> Iterator[tuple[Path, ...]]:
    """Folders of new groups with these limits, whose processes are killed at the end; () if impossible."""
    made: list[Path] = []  # complete even if a signal interrupts `_make`
    try:
        if not _make(made, limits, root):
            _remove(made)
            made.clear()
        yield tuple(made)
    finally:
        _remove(made)


def available(root: Path = ROOT) -> bool:
    """Whether this process may make groups that limit memory and processes."""
    with control_groups(ResourceLimits(), root) as made:
        return bool(made)


def join(groups: Sequence[Path]) -> None:
    """Put the calling process into the groups. Raises OSError."""
    for group in groups:
        (group / "cgroup.procs").write_text("0", encoding="ascii")


def memory_kills(groups: Sequence[Path]) -> int:
    """How many programs the kernel has killed because the group had no memory left."""
    return sum(
        _counter(group / "memory.oom_control", "oom_kill") + _counter(group / "memory.events", "oom_kill")
        for group in groups
    )


def refused_processes(groups: Sequence[Path]) -> int:
    """How often the kernel refused to give the group another process or thread."""
    return sum(_counter(group / "pids.events", "max") for group in groups)


def cpu_seconds(groups: Sequence[Path]) -> float:
    """CPU time of everything that ever ran in the group; 0 if nobody counts it."""
    nanoseconds = sum(_number(group / "cpuacct.usage") for group in groups)
    return nanoseconds / 1e9 + sum(_counter(group / "cpu.stat", "usage_usec") for group in groups) / 1e6


def _make(made: list[Path], limits: ResourceLimits, root: Path) -> bool:
    name = f"ros2course-{os.getpid()}-{_started(os.getpid())}-{next(_NUMBERS)}"
    try:
        for parent in _parents(root):
            _sweep(parent)
            made.append(parent / name)
            made[-1].mkdir()
            _limit(made[-1], limits)
    except OSError:  # not ours to change: the limits of each program and the watchdog remain
        return False
    return True


def _parents(root: Path) -> tuple[Path, ...]:
    """The groups in which to make new ones, one for each tree; none if that is impossible."""
    own = _own_groups()
    if (root / "cgroup.controllers").exists():
        return _of_version_2(root / own.get("", "/").lstrip("/"), root)
    names = (*_NEEDED, "cpu", "cpuacct")
    all_places = [(name, root / name / own.get(name, "/").lstrip("/")) for name in names]
    usable = {name: place for name, place in all_places if os.access(place, os.W_OK)}
    # Two controllers may share one tree, under two names.
    places = list(dict.fromkeys(place.resolve() for place in usable.values()))
    return tuple(places) if usable.keys() >= set(_NEEDED) else ()


def _own_groups() -> dict[str, str]:
    """The path of our own group, by its controller's name, which is "" in version 2."""
    found: dict[str, str] = {}
    with contextlib.suppress(OSError, ValueError):
        for line in Path("/proc/self/cgroup").read_text(encoding="utf-8").splitlines():
            _, controllers, path = line.split(":", 2)
            found.update(dict.fromkeys(controllers.split(","), path))
    return found


def _of_version_2(own: Path, root: Path) -> tuple[Path, ...]:
    """The nearest group, from ours upward, whose children may have limits.

    Except for the root, a group that has processes cannot pass limits on. Ours has one: this process.
    """
    for group in (own, *(above for above in own.parents if above.is_relative_to(root))):
        switch = group / "cgroup.subtree_control"
        with contextlib.suppress(OSError):
            if not set(_NEEDED) <= set(switch.read_text(encoding="ascii").split()):
                switch.write_text(" ".join(f"+{name}" for name in (*_NEEDED, "cpu")), encoding="ascii")
            # To put processes there, we must be allowed to change all groups below it.
            if os.access(group, os.W_OK) and os.access(group / "cgroup.procs", os.W_OK):
                return (group,)
    return ()


def _limit(group: Path, limits: ResourceLimits) -> None:
    values = {
        "memory.limit_in_bytes": str(limits.memory),
        "memory.kmem.tcp.limit_in_bytes": str(limits.memory // 8),  # all sockets; memory.max counts them
        "memory.max": str(limits.memory),
        "memory.swap.max": "0",
        "pids.max": str(limits.processes),
        "cpu.shares": _SHARES,
        "cpu.weight": _WEIGHT,
    }
    for name, value in values.items():
        if (group / name).exists():  # each tree and each version has some of them
            (group / name).write_text(value, encoding="ascii")


def _sweep(parent: Path) -> None:
    """Remove the groups of processes that were killed before they could do it."""
    for group in parent.glob("ros2course-*"):
        found = _LEFT.fullmatch(group.name)
        if found and _started(int(found[1])) != int(found[2]):
            with contextlib.suppress(OSError):
                group.rmdir()


def _started(pid: int) -> int:
    """When the process began, in ticks since boot; 0 if it has ended. A pid may be reused; this differs."""
    with contextlib.suppress(OSError):
        fields = Path(f"/proc/{pid}/stat").read_bytes().rpartition(b")")[2].split()
        return int(fields[19]) if fields[0] not in (b"Z", b"X") else 0
    return 0


def _remove(groups: Sequence[Path]) -> None:
    deadline = time.monotonic() + _REMOVAL
    for group in groups:
        while not _is_removed(group) and time.monotonic() < deadline:
            os.sched_yield()


def _is_removed(group: Path) -> bool:
    try:
        group.rmdir()
    except FileNotFoundError:
        return True
    except OSError as error:
        if error.errno != errno.EBUSY:
            return True  # waiting would not change that
        _kill(group)
        return False
    return True


def _kill(group: Path) -> None:
    with contextlib.suppress(OSError, ValueError):
        for pid in (group / "cgroup.procs").read_text(encoding="ascii").split():
            os.kill(int(pid), signal.SIGKILL)


def _number(file: Path) -> int:
    try:
        return int(file.read_text(encoding="ascii"))
    except (OSError, ValueError):
        return 0


def _counter(file: Path, name: str) -> int:
    with contextlib.suppress(OSError, ValueError):
        for line in file.read_text(encoding="ascii").splitlines():
            key, _, value = line.partition(" ")
            if key == name:
                return int(value)
    return 0


@dataclass(frozen=True)
class Identity:
    """user: None if we are not root: then programs run as the caller, in a user namespace.

    control_groups: folders; empty if there can be none.
    """

    user: int | None
    control_groups: tuple[Path, ...] = ()


@contextlib.contextmanager
def new_identity(limits: ResourceLimits) -> Iterator[Identity]:
    """Held until the context ends. Raises MissingHere if all ids are taken."""
    with contextlib.ExitStack() as stack:
        user = stack.enter_context(_own_user()) if os.geteuid() == 0 else None
        yield Identity(user, stack.enter_context(control_groups(limits)))


@contextlib.contextmanager
def _own_user() -> Iterator[int]:
    """As with domains, the claim is an abstract socket, which the kernel frees however we end."""
    start, ids = os.getpid(), _usable()
    for step in range(len(ids)):
        user = ids[(start + step) % len(ids)]
        with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as claim:
            try:
                claim.bind(f"\0ros2course-user-{user}")
            except OSError:
                continue
            yield user
            return
    raise MissingHere("All user ids for submissions are in use.", "Wait until other gradings have ended.")


def _usable() -> range:
    mapped = [line.split() for line in _MAP.read_text(encoding="ascii").splitlines()]
    for ids in _RANGES:
        if any(int(first) <= ids[0] and ids[-1] < int(first) + int(count) for first, _, count in mapped):
            return ids
    return _RANGES[-1]
