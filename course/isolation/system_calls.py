"""System calls that no program of a submission may make: a filter for seccomp(2).

Programs have no rights already. The filter refuses what needs no rights: user namespaces, in which a
program would be root again; looking into other processes; the parts of the kernel that were attacked most;
and memory that counts for no process. It allows local sockets, TCP, UDP, and questions about the program's
own network. Refused calls fail with EPERM, as in most containers. Calls that libraries can do
without fail as if the kernel did not know them. Calls that set priorities seem to succeed but change
nothing: a program with a low priority could always claim that the machine was too busy, and Fast DDS prints
errors if they fail.
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
_UNIX, _INET, _INET6, _NETLINK = 1, 2, 10, 16
_KIND = 0xF  # these bits of a socket's type; the others are flags
_STREAM, _DATAGRAM = 1, 2
_PROTOCOLS = (0, 6, 17)  # the type's default, TCP, UDP; not MPTCP, SCTP, and others
_ROUTES = 0  # of netlink's protocols: which networks there are, not who uses them (sock_diag)
_TYPING = (0x5412, 0x541C)  # TIOCSTI, TIOCLINUX: type into a terminal in its user's place
# The same numbers everywhere: io_uring, open_tree to fspick, pidfd_getfd, process_madvise, mount_setattr,
# quotactl_fd, landlock, memfd_secret, process_mrelease.
_REFUSED = (425, 426, 427, 428, 429, 430, 431, 432, 433, 438, 440, 442, 443, 444, 445, 446, 447, 448)
_CLONE3 = 435  # its flags are in memory, which no filter sees; without it, libraries use clone
_UNKNOWN = 454  # calls from here on are newer than this list; x32 has far higher numbers

_LOAD, _EQUAL, _ANY_BIT, _AT_LEAST, _AND, _RETURN = 0x20, 0x15, 0x45, 0x35, 0x54, 0x06
_NUMBER, _ARCHITECTURE, _FIRST, _SECOND, _THIRD = 0, 4, 16, 24, 32  # offsets in struct seccomp_data
_ALLOW, _FAIL = 0x7FFF_0000, 0x0005_0000


@dataclass(frozen=True)
class _Machine:
    """audit: its AUDIT_ARCH. refused, missing, idle: numbers of further calls, see `_MACHINES`."""

    audit: int
    clone: int
    socket: int
    socketpair: int
    ioctl: int
    refused: tuple[int, ...]
    missing: tuple[int, ...]
    idle: tuple[int, ...]


# ptrace, process_vm_readv, process_vm_writev, kcmp; unshare, setns, mount, umount2, pivot_root, chroot;
# keyctl, add_key, request_key; bpf, perf_event_open, userfaultfd, fanotify_init, syslog, open_by_handle_at,
# name_to_handle_at; mbind, set_mempolicy, migrate_pages, move_pages; on the first also modify_ldt.
# Missing: memfd_create and shmget, whose memory only control groups would count.
# Idle: setpriority, sched_setparam, sched_setscheduler, sched_setattr, ioprio_set.
_MACHINES = {
    "x86_64": _Machine(
        0xC000_003E,
        *(56, 41, 53, 16),
        (
            *(101, 310, 311, 312, 272, 308, 165, 166, 155, 161, 250, 248, 249),
            *(321, 298, 323, 300, 103, 304, 303, 237, 238, 256, 279, 154),
        ),
        (319, 29),
        (141, 142, 144, 314, 251),
    ),
    "aarch64": _Machine(
        0xC000_00B7,
        *(220, 198, 199, 29),
        (
            *(117, 270, 271, 272, 97, 268, 40, 39, 41, 51, 219, 217, 218),
            *(280, 241, 282, 262, 116, 265, 264, 235, 237, 238, 239),
        ),
        (279, 194),
        (140, 118, 119, 274, 30),
    ),
}


def refusing(name: str = platform.machine()) -> bytes:
    """The filter for this kind of machine, an array of struct sock_filter; empty if none is known."""
    machine = _MACHINES.get(name)
    return b"" if machine is None else b"".join(_instructions(machine))


def _instructions(machine: _Machine) -> Iterable[bytes]:
    # Calls of another architecture have other numbers.
    yield from (_do(_LOAD, _ARCHITECTURE), _do(_EQUAL, machine.audit, 1, 0), _fail(errno.ENOSYS))
    yield from (_do(_LOAD, _NUMBER), _do(_AT_LEAST, _UNKNOWN, 0, 1), _fail(errno.ENOSYS))
    for number in (*machine.refused, *_REFUSED):
        yield from _when(number, [_fail(errno.EPERM)])
    for number in (*machine.missing, _CLONE3):
        yield from _when(number, [_fail(errno.ENOSYS)])
    for number in machine.idle:
        yield from _when(number, [_fail(0)])
    namespaces = (_do(_ANY_BIT, _NEW_NAMESPACES, 0, 1), _fail(errno.EPERM))
    yield from _when(machine.clone, [_do(_LOAD, _FIRST), *namespaces, _do(_RETURN, _ALLOW)])
    yield from _when(machine.socket, [_do(_LOAD, _FIRST), *_sockets()])
    pair = [_do(_LOAD, _FIRST), *_if_any([_UNIX]), _fail(errno.EAFNOSUPPORT)]
    yield from _when(machine.socketpair, pair)
    typing = [step for request in _TYPING for step in _when(request, [_fail(errno.EPERM)])]
    yield from _when(machine.ioctl, [_do(_LOAD, _SECOND), *typing, _do(_RETURN, _ALLOW)])
    yield _do(_RETURN, _ALLOW)


def _sockets() -> Iterable[bytes]:
    """The family was loaded last."""
    protocol = [_do(_LOAD, _THIRD), *_if_any(_PROTOCOLS), _fail(errno.EPROTONOSUPPORT)]
    kinds = [step for kind in (_STREAM, _DATAGRAM) for step in _when(kind, protocol)]
    internet = [_do(_LOAD, _SECOND), _do(_AND, _KIND), *kinds, _fail(errno.ESOCKTNOSUPPORT)]
    yield from _if_any([_UNIX])
    yield from _when(_INET, internet)
    yield from _when(_INET6, internet)
    routes = [_do(_LOAD, _THIRD), *_if_any([_ROUTES]), _fail(errno.EPROTONOSUPPORT)]
    yield from _when(_NETLINK, routes)
    yield _fail(errno.EAFNOSUPPORT)


def _if_any(values: Iterable[int]) -> list[bytes]:
    """Allow the call if the last loaded value is one of these."""
    return [step for value in values for step in _when(value, [_do(_RETURN, _ALLOW)])]


def _when(value: int, steps: list[bytes]) -> list[bytes]:
    """Take these steps if the last loaded value is this one. They must end the filter."""
    return [_do(_EQUAL, value, 0, len(steps)), *steps]


def _fail(number: int) -> bytes:
    return _do(_RETURN, _FAIL | number)


def _do(code: int, value: int, true: int = 0, false: int = 0) -> bytes:
    return struct.pack("=HBBI", code, true, false, value)
