"""What this machine offers to keep a submission apart, and what is chosen for a check and for a build.

What was found to work is not tried again before each check, until the machine starts again or the program
changes. Only success is kept: anyone who has just installed or allowed something sees it at once.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from course import isolation
from course.files import write_atomic
from course.isolation.domains import free_domain
from course.isolation.identity import Identity, new_identity
from course.isolation.isolation_plan import IsolationPlan, Level, ResourceLimits
from course.isolation.view import View, view
from course.rosenv import Ros, cache_dir

# Under which name it is remembered that this works here.
KNOWN, _KNOWN_BUILDS = "containment", "confined-builds"
_BOOT = Path("/proc/sys/kernel/random/boot_id")


@dataclass(frozen=True)
class MachinePlaces:
    """What the grading process needs of the machine, also below /tmp, which it has to itself otherwise."""

    read: tuple[Path, ...] = ()
    write: tuple[Path, ...] = ()


@dataclass(frozen=True)
class Isolation:
    """How one check is kept apart.

    plan: for the grading process. environment: added to its environment. missing: a quiet line on what this
    machine lacks, or None. identity: what the sandbox's programs are; None without a sandbox.
    """

    level: Level
    plan: IsolationPlan | None = None
    environment: Mapping[str, str] = field(default_factory=dict)
    missing: str | None = None
    identity: Identity | None = None
    limits: ResourceLimits = field(default_factory=ResourceLimits)

    @property
    def prefix(self) -> tuple[str, ...]:
        """What stands before a command that runs where the grading process does."""
        return isolation.ISOLATION.prefix(self.plan) if self.plan else ()

    def sandbox(self, seen: View) -> IsolationPlan | None:
        """For programs of the submission that see this."""
        return _plan(self.identity, seen, self.limits) if self.identity else None


@contextlib.contextmanager
def isolated(
    places: MachinePlaces | None = None, *, namespaces: bool = True, limits: ResourceLimits | None = None
) -> Iterator[Isolation]:
    """The strongest level that this machine offers without root; held until the end.

    places: None for a program of ours, which sees the whole machine and needs no sandbox. namespaces: False
    takes a ROS domain even where namespaces would work.
    """
    limits, missing = limits or ResourceLimits(), None
    if places is not None and namespaces:
        missing = unless_known(KNOWN, isolation.ISOLATION.program(), lambda: obstacle_to(Level.CONTAINED))
        if missing is None:
            with new_identity(limits) as identity:
                write = (*places.write, *identity.control_groups)
                plan = IsolationPlan(shown=_texts(places.read), write=_texts(write), machine="read")
                yield Isolation(Level.CONTAINED, plan, identity=identity, limits=limits)
            return
    no_namespaces = obstacle_to(Level.NAMESPACES) if namespaces else None
    if namespaces and no_namespaces is None:
        yield Isolation(Level.NAMESPACES, IsolationPlan(machine="write"), missing=missing)
        return
    with free_domain() as domain:
        environment = {"ROS_DOMAIN_ID": str(domain), "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
        yield Isolation(Level.DOMAIN, None, environment, no_namespaces)


@contextlib.contextmanager
def isolated_build(
    ros: Ros,
    environment: Mapping[str, str],
    writable: Sequence[Path],
    more: Sequence[Path],
    limits: ResourceLimits,
) -> Iterator[IsolationPlan | None]:
    """No network, no process but its own, no file but what it needs; held until the end.

    writable: folders, which the plan's user may write once they are theirs. more: what else it reads. None
    where that cannot be had.
    """
    known = isolation.ISOLATION
    if unless_known(_KNOWN_BUILDS, known.program(), known.build_obstacle) is not None:
        yield None
        return
    seen = view(ros, environment, more)
    with new_identity(limits) as identity:
        yield _plan(identity, seen, limits, _texts(writable), own_network=True)


def obstacle_to(level: Level) -> str | None:
    """Why this level cannot be had here, in one line with what to do; None when it can."""
    return isolation.ISOLATION.obstacle(level)


def _plan(
    identity: Identity,
    seen: View,
    limits: ResourceLimits,
    write: tuple[str, ...] = (),
    own_network: bool = False,
) -> IsolationPlan:
    groups = _texts(identity.control_groups)
    return IsolationPlan(identity.user, seen.shown, seen.empty, groups, limits, own_network, write)


def _texts(paths: Sequence[Path]) -> tuple[str, ...]:
    return tuple(map(str, paths))


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
