"""What no program of a submission may ask of the kernel: a filter of system calls, as seccomp(2) takes it.

Rights are gone already. This takes away what needs none: namespaces of users, in which one would be root
again, looking into other processes, and those parts of the kernel that have been its weakest. It also
leaves network families out that namespaces do not hold, such as the one between a virtual machine and its
host. Calls that are refused fail with EPERM, as they do in most containers.
Source: seccomp(2), and the kernel's tables of system calls for both architectures.
"""

from __future__ import annotations

import errno
import platform
import struct
from collections.abc import Iterable
from dataclasses import dataclass

# All namespaces: mount, cgroup, uts, ipc, user, pid, net.
_NEW_NAMESPACES = 0x7E02_0000
_FAMILIES = (1, 2, 10, 16)  # unix, inet, inet6, netlink
_TYPING = (0x5412, 0x541C)  # TIOCSTI, TIOCLINUX: input for a terminal, in its user's place
# The same numbers everywhere: io_uring, open_tree to fspick, pidfd_getfd, process_madvise, mount_setattr.
_REFUSED = (425, 426, 427, 428, 429, 430, 431, 432, 433, 438, 440, 442)
_CLONE3 = 435  # its flags lie in memory, where no filter sees them; without it, libraries take clone
_X32 = 0x4000_0000

_LOAD, _EQUAL, _ANY_BIT, _AT_LEAST, _RETURN = 0x20, 0x15, 0x45, 0x35, 0x06
_NUMBER, _ARCHITECTURE, _FIRST, _SECOND = 0, 4, 16, 24  # offsets in struct seccomp_data
_ALLOW, _FAIL = 0x7FFF_0000, 0x0005_0000


@dataclass(frozen=True)
class _Machine:
    """audit: its AUDIT_ARCH. refused: numbers of further calls, see `_MACHINES`."""

    audit: int
    clone: int
    socket: int
    ioctl: int
    refused: tuple[int, ...]


# ptrace, process_vm_readv, process_vm_writev, kcmp; unshare, setns, mount, umount2, pivot_root, chroot;
# keyctl, add_key, request_key; bpf, perf_event_open, userfaultfd, fanotify_init, syslog, open_by_handle_at.
_MACHINES = {
    "x86_64": _Machine(
        0xC000_003E,
        *(56, 41, 16),
        (101, 310, 311, 312, 272, 308, 165, 166, 155, 161, 250, 248, 249, 321, 298, 323, 300, 103, 304),
    ),
    "aarch64": _Machine(
        0xC000_00B7,
        *(220, 198, 29),
        (117, 270, 271, 272, 97, 268, 40, 39, 41, 51, 219, 217, 218, 280, 241, 282, 262, 116, 265),
    ),
}


def refusing(name: str = platform.machine()) -> bytes:
    """The filter for this kind of machine, an array of struct sock_filter; empty where none is known."""
    machine = _MACHINES.get(name)
    return b"" if machine is None else b"".join(_instructions(machine))


def _instructions(machine: _Machine) -> Iterable[bytes]:
    # Calls of another architecture have other numbers.
    yield from (_do(_LOAD, _ARCHITECTURE), _do(_EQUAL, machine.audit, 1, 0), _fail(errno.ENOSYS))
    yield from (_do(_LOAD, _NUMBER), _do(_AT_LEAST, _X32, 0, 1), _fail(errno.ENOSYS))
    for number in (*machine.refused, *_REFUSED):
        yield from _when(number, [_fail(errno.EPERM)])
    yield from _when(_CLONE3, [_fail(errno.ENOSYS)])
    namespaces = (_do(_ANY_BIT, _NEW_NAMESPACES, 0, 1), _fail(errno.EPERM))
    yield from _when(machine.clone, [_do(_LOAD, _FIRST), *namespaces, _do(_RETURN, _ALLOW)])
    known = [step for family in _FAMILIES for step in _when(family, [_do(_RETURN, _ALLOW)])]
    yield from _when(machine.socket, [_do(_LOAD, _FIRST), *known, _fail(errno.EAFNOSUPPORT)])
    typing = [step for request in _TYPING for step in _when(request, [_fail(errno.EPERM)])]
    yield from _when(machine.ioctl, [_do(_LOAD, _SECOND), *typing, _do(_RETURN, _ALLOW)])
    yield _do(_RETURN, _ALLOW)


def _when(value: int, steps: list[bytes]) -> list[bytes]:
    """These steps if what was loaded last is the value. They must end the filter."""
    return [_do(_EQUAL, value, 0, len(steps)), *steps]


def _fail(number: int) -> bytes:
    return _do(_RETURN, _FAIL | number)


def _do(code: int, value: int, true: int = 0, false: int = 0) -> bytes:
    return struct.pack("=HBBI", code, true, false, value)
