"""What a program may see, write, and use: plain data, sent to the grading process."""

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
# The grading process's folder in memory, and the folder in it that programs may write.
SCRATCH, PROGRAMS = Path("/dev/shm/ros2course"), "programs"
# Bytes of /tmp and of /dev/shm, each.
TEMPORARY = 64 * _MB
# The address sanitizer reserves 20 TB of addresses, one mark for each byte, and no memory.
_FOR_SANITIZERS = 64 * 1024 * 1024 * _MB
# For the grading process: it limits what it keeps of a submission, but its middleware limits nothing.
_OURS = 2048 * _MB


class Level(str, Enum):
    """How well a submission is isolated.

    CONTAINED: the grading process has its own namespaces, reads the machine's files, and writes none;
    inside, the submission's programs run in a sandbox, as a user without rights. NAMESPACES: only the outer
    layer. DOMAIN: no layer, but a ROS_DOMAIN_ID that nobody else on this machine uses, and discovery
    on this machine only.
    """

    CONTAINED = "contained"
    NAMESPACES = "namespaces"
    DOMAIN = "domain"


@dataclass(frozen=True)
class ResourceLimits:
    """memory, scratch: bytes, of the whole tree. processes: including threads. file: bytes of one file.

    files: open files of one program. cpu: seconds, of the whole tree. address_space: bytes of one program.
    terminals: pseudo-terminals, of the whole tree; the machine has about 3,000.
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
    """user: the user id of programs; None for the caller's own, in a user namespace.

    shown, empty, linked: what programs can read, see `view.View`. control_groups: their folders.
    own_network: with its own network, in which the grading process hears nothing. write: folders that they
    can write to. machine: whether they can read or write the machine's other files; only for our programs.
    """

    user: int | None = None
    shown: tuple[str, ...] = ()
    empty: tuple[str, ...] = ()
    control_groups: tuple[str, ...] = ()
    limits: ResourceLimits = field(default_factory=ResourceLimits)
    own_network: bool = False
    write: tuple[str, ...] = ()
    machine: Literal["hidden", "read", "write"] = "hidden"
    linked: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class IsolatedProcess:
    """What `isolation.start` started.

    saw_the_end: call it afterwards. It says whether the process ended by itself, and was not killed together
    with the processes around it, by us or from outside.
    """

    process: subprocess.Popen[bytes]
    saw_the_end: Callable[[], bool] = lambda: True


@dataclass(frozen=True)
class Holder:
    """pid: of the first process in the namespaces, as we see it. is_alive: whether it is still alive."""

    pid: int
    is_alive: Callable[[], bool]


@dataclass(frozen=True)
class Restriction:
    """what: the setting, and what it does. step: how to allow what is needed."""

    what: str
    step: str


class Started(Protocol):
    """A program that leads its own session on its terminal. It keeps its pid until it is reaped."""

    pid: int

    def reap(self) -> int:
        """Wait for its end, and return its exit code, or minus the signal that ended it."""

    def send_signal(self, number: signal.Signals) -> None:
        """Only to the program itself. Does nothing if it has ended."""


class Starter(Protocol):
    """Starts programs on terminals. Raises OSError if a program cannot be started at all."""

    def __call__(
        self,
        command: Sequence[str],
        terminal: int,
        environment: Mapping[str, str],
        folder: Path,
        descriptors: Sequence[int],
        own_memory: bool = False,
    ) -> Started:
        """terminal: becomes its controlling terminal. descriptors: ours, which it inherits.

        own_memory: with its own private /dev/shm.
        """


def for_sanitizers(limits: ResourceLimits) -> ResourceLimits:
    """The same, for programs compiled with the address sanitizer."""
    return replace(limits, address_space=max(limits.address_space, _FOR_SANITIZERS))


def bound_ourselves() -> None:
    """Limit our own memory, however large a message claims to be."""
    hard = resource.getrlimit(resource.RLIMIT_DATA)[1]
    most = _OURS if hard == resource.RLIM_INFINITY else min(_OURS, hard)
    resource.setrlimit(resource.RLIMIT_DATA, (most, hard))


def most_processes(limits: ResourceLimits) -> int:
    """For RLIMIT_NPROC: a little more than the control group allows, because the group counts refusals."""
    return limits.processes + limits.processes // 8


def rlimits(limits: ResourceLimits) -> tuple[tuple[int, int], ...]:
    """Numbers and values for setrlimit(2), for each program: the kernel enforces them, whatever else fails.

    RLIMIT_NPROC counts all processes of a user, and each arena is its own user.
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
