"""What a program may see, write and use up: plain data, which travels to the grading process."""

from __future__ import annotations

import resource
import signal
import subprocess
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from enum import Enum
from pathlib import Path
from typing import Literal, Protocol

from course.model import replace

_MB = 1024 * 1024
# The grading process's folder in memory, and where in it programs have the one that they may write.
SCRATCH, PROGRAMS = Path("/dev/shm/ros2course"), "programs"
# Bytes of /tmp and of /dev/shm, each.
TEMPORARY = 64 * _MB
# The address sanitizer marks each byte of all addresses there are: it takes 20 TB of them, and no memory.
_FOR_SANITIZERS = 64 * 1024 * 1024 * _MB
# Of the grading process: what it keeps of a submission is bounded, what its middleware puts together is not.
_OURS = 2048 * _MB


class Level(str, Enum):
    """How well a submission is kept apart.

    CONTAINED: the grading process in namespaces of its own, which reads the machine's files and writes none;
    in there, the submission's programs in a sandbox, as a user without rights. NAMESPACES: the first of these
    layers alone. DOMAIN: none of them; a ROS_DOMAIN_ID that nobody else on this machine uses, and discovery
    on this machine only.
    """

    CONTAINED = "contained"
    NAMESPACES = "namespaces"
    DOMAIN = "domain"


@dataclass(frozen=True)
class ResourceLimits:
    """memory, scratch: bytes, of the whole tree. processes: threads count, too. file: bytes of one file.

    files: open ones in one program. cpu: seconds, of the whole tree. address_space: bytes of one program.
    terminals: pseudo-terminals, of the whole tree; the machine has some 3,000.
    """

    memory: int = 1024 * _MB
    scratch: int = 256 * _MB
    processes: int = 512
    file: int = 256 * _MB
    files: int = 1024
    cpu: float = 120.0
    address_space: int = 16 * 1024 * _MB
    terminals: int = 32


BUILD = ResourceLimits(memory=3072 * _MB, scratch=1024 * _MB, processes=256, file=512 * _MB, cpu=900.0)


@dataclass(frozen=True)
class IsolationPlan:
    """user: the user id that programs get; None: the caller's own, in a user namespace.

    shown, empty: what can be read, see `view.View`. control_groups: folders of the control groups that
    programs are put into. own_network: with a network of its own, in which the grading process hears nothing.
    write: folders that can be written to. machine: whether all files of the machine can be read, or written,
    beside those; only for programs of ours.
    """

    user: int | None = None
    shown: tuple[str, ...] = ()
    empty: tuple[str, ...] = ()
    control_groups: tuple[str, ...] = ()
    limits: ResourceLimits = field(default_factory=ResourceLimits)
    own_network: bool = False
    write: tuple[str, ...] = ()
    machine: Literal["hidden", "read", "write"] = "hidden"


@dataclass(frozen=True)
class IsolatedProcess:
    """What `isolation.start` started.

    saw_the_end: asked when it is over, whether it ended by itself. Else it was killed together with what is
    around it: by us, or from outside.
    """

    process: subprocess.Popen[bytes]
    saw_the_end: Callable[[], bool] = lambda: True


@dataclass(frozen=True)
class Holder:
    """pid: as we see it, of the first process in the namespaces. is_alive: whether nobody has killed it."""

    pid: int
    is_alive: Callable[[], bool]


@dataclass(frozen=True)
class Restriction:
    """what: the setting, and what it does. step: how to allow what is needed."""

    what: str
    step: str


class Started(Protocol):
    """A program that leads a session of its own on its terminal. Its pid is its own until it is reaped."""

    pid: int

    def reap(self) -> int:
        """Its exit code, or minus the signal that ended it; waits for that."""

    def send_signal(self, number: signal.Signals) -> None:
        """To the program alone. Nothing if it has ended."""


class Starter(Protocol):
    """Starts programs on terminals. Raises OSError when one cannot be started at all."""

    def __call__(
        self,
        command: Sequence[str],
        terminal: int,
        environment: Mapping[str, str],
        folder: Path,
        descriptors: Sequence[int],
        own_memory: bool = False,
    ) -> Started:
        """terminal: becomes its controlling one. descriptors: of ours, which it inherits.

        own_memory: with a /dev/shm that it shares with nobody.
        """


def for_sanitizers(limits: ResourceLimits) -> ResourceLimits:
    """The same, for programs that are compiled with the address sanitizer."""
    return replace(limits, address_space=max(limits.address_space, _FOR_SANITIZERS))


def bound_ourselves() -> None:
    """No message, however large it says it is, takes more of this machine's memory through us."""
    hard = resource.getrlimit(resource.RLIMIT_DATA)[1]
    most = _OURS if hard == resource.RLIM_INFINITY else min(_OURS, hard)
    resource.setrlimit(resource.RLIMIT_DATA, (most, hard))


def most_processes(limits: ResourceLimits) -> int:
    """For RLIMIT_NPROC: a little more than the control group allows, which takes note of what it refuses."""
    return limits.processes + limits.processes // 8


def rlimits(limits: ResourceLimits) -> tuple[tuple[int, int], ...]:
    """Numbers and values for setrlimit(2), for each program: the kernel holds them, whatever else fails.

    RLIMIT_NPROC counts all of a user's, and each arena is a user of its own.
    """
    return (
        (resource.RLIMIT_NPROC, most_processes(limits)),
        (resource.RLIMIT_FSIZE, limits.file),
        (resource.RLIMIT_NOFILE, limits.files),
        (resource.RLIMIT_CPU, int(limits.cpu)),
        (resource.RLIMIT_AS, limits.address_space),
        (resource.RLIMIT_CORE, 0),
        (resource.RLIMIT_MEMLOCK, 8 * _MB),
        (resource.RLIMIT_MSGQUEUE, _MB),
    )
