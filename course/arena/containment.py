"""Where one submission is graded: both layers, as far as this machine allows.

`contained`   the grading process in namespaces of its own, which reads the machine's files and writes none;
              in there, the submission's programs in a sandbox, as a user without rights.
`namespaces`  the first layer alone.
`domain`      none of them; see `enclosure`.
"""

from __future__ import annotations

import contextlib
import os
import subprocess
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from course.arena.enclosure import Enclosure, bwrap, enclosure, namespace_obstacle, said
from course.arena.remembered import unless_known
from course.arena.sandbox.identity import Identity, identity
from course.arena.sandbox.inner import arguments
from course.arena.sandbox.limits import Limits
from course.arena.sandbox.plan import Plan

SCRATCH = Path("/dev/shm/ros2course")
# What the submission's programs may write; the rest of SCRATCH is ours.
PROGRAMS = "programs"
# Under which name it is remembered that this works here.
KNOWN = "containment"
_OUTER = (
    "--die-with-parent --unshare-net --unshare-pid --unshare-ipc --ro-bind / / --proc /proc --dev /dev"
).split()
_OURS = 64 * 1024 * 1024
_PROBE_TIMEOUT = 10.0


@dataclass(frozen=True)
class Places:
    """What the grading process needs of the machine, also below /tmp, which it has to itself otherwise."""

    read: tuple[Path, ...] = ()
    write: tuple[Path, ...] = ()


@dataclass(frozen=True)
class Containment:
    """around: how to start the grading process. who: what the sandbox's programs are; None without one."""

    around: Enclosure
    who: Identity | None = None
    limits: Limits = field(default_factory=Limits)

    def plan(self, shown: Iterable[str], hidden: Iterable[str]) -> Plan | None:
        """The sandbox for programs that need these files to be shown and hidden."""
        if self.who is None:
            return None
        groups = tuple(str(group) for group in self.who.control_groups)
        return Plan(self.who.user, tuple(shown), tuple(hidden), groups, self.limits)


@contextlib.contextmanager
def containment(
    places: Places, *, namespaces: bool = True, limits: Limits | None = None
) -> Iterator[Containment]:
    """The strongest that this machine offers without root; held until the end.

    namespaces: False takes a ROS domain even where namespaces would work.
    """
    limits = limits or Limits()
    obstacle = unless_known(KNOWN, bwrap(), sandbox_obstacle) if namespaces else ""
    if obstacle is not None:
        with enclosure(namespaces=namespaces) as around:
            yield Containment(around if around.missing else _less(around, obstacle))
        return
    with identity(limits) as who:
        prefix = (bwrap(), *_OUTER, *_mounts(places, who, limits), "--chdir", "/")
        yield Containment(Enclosure("contained", prefix), who, limits)


def sandbox_obstacle() -> str | None:
    """Why submissions cannot be contained here, in one line with what to do; None when they can."""
    try:
        done = subprocess.run(
            [bwrap(), *_OUTER, bwrap(), *arguments(Plan(_some_user(), ()), ()), "--", "/bin/true"],
            capture_output=True,
            timeout=_PROBE_TIMEOUT,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired):
        return namespace_obstacle() or "bubblewrap does not start here"
    if done.returncode == 0:
        return None
    return namespace_obstacle() or f"this system allows no sandbox within namespaces ({said(done)})"


def _some_user() -> int | None:
    return 0 if os.geteuid() == 0 else None


def _less(around: Enclosure, obstacle: str) -> Enclosure:
    return Enclosure(around.kind, around.prefix, around.environment, obstacle or None)


def _mounts(places: Places, who: Identity, limits: Limits) -> Iterator[str]:
    yield from ("--size", str(_OURS), "--tmpfs", "/dev/shm", "--dir", str(SCRATCH))
    yield from ("--size", str(limits.scratch), "--tmpfs", str(SCRATCH / PROGRAMS))
    yield from ("--tmpfs", "/tmp")
    for path in places.read:
        # Everything else is there already.
        if path.is_relative_to("/tmp") or path.is_relative_to("/dev/shm"):
            yield from ("--ro-bind-try", str(path), str(path))
    for path in (*places.write, *who.control_groups):
        yield from ("--bind-try", str(path), str(path))
