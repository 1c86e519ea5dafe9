"""What one submission may use up, all its programs together unless it says otherwise."""

from __future__ import annotations

import resource
from dataclasses import dataclass, replace

_MB = 1024 * 1024


@dataclass(frozen=True)
class Limits:
    """memory, scratch: bytes, of the whole tree. processes: threads count, too. file: bytes of one file.

    files: open ones in one program. cpu: seconds, of the whole tree. address_space: bytes of one program.
    """

    memory: int = 1024 * _MB
    scratch: int = 256 * _MB
    processes: int = 512
    file: int = 256 * _MB
    files: int = 1024
    cpu: float = 120.0
    address_space: int = 16 * 1024 * _MB


# The address sanitizer marks each byte of all addresses there are: it takes 20 TB of them, and no memory.
_FOR_SANITIZERS = 64 * 1024 * 1024 * _MB


def for_sanitizers(limits: Limits) -> Limits:
    """The same, for programs that are compiled with the address sanitizer."""
    return replace(limits, address_space=max(limits.address_space, _FOR_SANITIZERS))


BUILD = Limits(memory=3072 * _MB, scratch=1024 * _MB, processes=256, file=512 * _MB, cpu=900.0)


# Of the grading process: what it keeps of a submission is bounded, what its middleware puts together is not.
_OURS = 2048 * _MB


def bound_ourselves() -> None:
    """No message, however large it says it is, takes more of this machine's memory through us."""
    hard = resource.getrlimit(resource.RLIMIT_DATA)[1]
    most = _OURS if hard == resource.RLIM_INFINITY else min(_OURS, hard)
    resource.setrlimit(resource.RLIMIT_DATA, (most, hard))


def most_processes(limits: Limits) -> int:
    """For RLIMIT_NPROC: a little more than the control group allows, which takes note of what it refuses."""
    return limits.processes + limits.processes // 8


def rlimits(limits: Limits) -> tuple[tuple[int, int], ...]:
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
