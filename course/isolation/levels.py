"""What this machine offers to isolate a submission, and what a check or a build gets.

A level that works is not tried again until the machine restarts or the program changes. Failures are not
remembered, so anyone who has just installed or allowed something sees the effect at once.
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
from course.isolation.view import View, linked, view
from course.rosenv import Ros, cache_dir

# The name under which a success is remembered.
KNOWN, _KNOWN_BUILDS = "containment", "confined-builds"
_BOOT = Path("/proc/sys/kernel/random/boot_id")


@dataclass(frozen=True)
class MachinePlaces:
    """Places that the grading process needs, even below /tmp, where it otherwise sees only its own files."""

    read: tuple[Path, ...] = ()
    write: tuple[Path, ...] = ()


@dataclass(frozen=True)
class Isolation:
    """How one check is isolated.

    plan: for the grading process. environment: added to its environment. missing: a line about what this
    machine lacks, or None. identity: of the sandbox's programs; None without a sandbox.
    """

    level: Level
    plan: IsolationPlan | None = None
    environment: Mapping[str, str] = field(default_factory=dict)
    missing: str | None = None
    identity: Identity | None = None
    limits: ResourceLimits = field(default_factory=ResourceLimits)

    @property
    def prefix(self) -> tuple[str, ...]:
        """What to put in front of a command that runs where the grading process does."""
        return isolation.ISOLATION.prefix(self.plan) if self.plan else ()

    def sandbox(self, seen: View) -> IsolationPlan | None:
        """A plan for the submission's programs, which see this."""
        return _plan(self.identity, seen, self.limits) if self.identity else None


@contextlib.contextmanager
def isolated(
    places: MachinePlaces | None = None, *, namespaces: bool = True, limits: ResourceLimits | None = None
) -> Iterator[Isolation]:
    """The strongest level that this machine offers without root; held until the context ends.

    places: None for our own program, which sees the whole machine and needs no sandbox. namespaces: False
    chooses a ROS domain even if namespaces would work.
    """
    limits, missing = limits or ResourceLimits(), None
    if places is not None and namespaces:
        missing = unless_known(KNOWN, isolation.ISOLATION.program(), lambda: obstacle_to(Level.CONTAINED))
        if missing is None:
            with contextlib.suppress(OSError):  # then packages are shown without links
                _packages_dir().mkdir(parents=True, exist_ok=True)
            with new_identity(limits) as identity:
                read, write = (*places.read, _packages_dir()), (*places.write, *identity.control_groups)
                plan = IsolationPlan(shown=_texts(read), write=_texts(write), machine="read")
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
    """No network, no processes but its own, no files but those it needs; None if that is not available.

    writable: folders that are given to the plan's user. more: what else the build reads.
    """
    known = isolation.ISOLATION
    if unless_known(_KNOWN_BUILDS, known.program(), known.build_obstacle) is not None:
        yield None
        return
    seen = view(ros, environment, more)
    with new_identity(limits) as identity:
        yield _plan(identity, seen, limits, _texts(writable), own_network=True)


def obstacle_to(level: Level) -> str | None:
    """Why this level is not available here, in one line with what to do; None if it is."""
    return isolation.ISOLATION.obstacle(level)


def _plan(
    identity: Identity,
    seen: View,
    limits: ResourceLimits,
    write: tuple[str, ...] = (),
    own_network: bool = False,
) -> IsolationPlan:
    groups, seen = _texts(identity.control_groups), linked(seen, _packages_dir())
    of = (seen.shown, seen.empty, groups, limits, own_network, write)
    return IsolationPlan(identity.user, *of, linked=seen.linked)


def _packages_dir() -> Path:
    """Where links to Python packages are."""
    return cache_dir(os.environ) / "packages"


def _texts(paths: Sequence[Path]) -> tuple[str, ...]:
    return tuple(map(str, paths))


def unless_known(name: str, program: str, obstacle: Callable[[], str | None]) -> str | None:
    """What `obstacle()` returns; it is called only if no success is remembered."""
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
    """Forget a success, because it did not work after all."""
    with contextlib.suppress(OSError):
        (cache_dir(os.environ) / "known" / name).unlink()


def _stamp(program: str) -> str | None:
    try:
        status = Path(program).stat()
        boot = _BOOT.read_text(encoding="ascii").strip()
    except OSError:
        return None
    return f"{boot} {os.geteuid()} {program} {status.st_mtime_ns} {status.st_size}"
