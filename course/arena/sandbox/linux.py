"""System calls that Python has no function for. Source: setns(2), prctl(2), seccomp(2), ioctl_ns(2)."""

from __future__ import annotations

import contextlib
import ctypes
import errno
import fcntl
import os
from collections.abc import Iterator

PR_SET_PDEATHSIG = 1
PR_SET_DUMPABLE = 4
PR_SET_SECCOMP = 22
PR_CAPBSET_DROP = 24
PR_SET_NO_NEW_PRIVS = 38
_SECCOMP_MODE_FILTER = 2
_MOST_RIGHTS = 64
_NS_GET_PARENT = 0xB702
_LIBC = ctypes.CDLL(None, use_errno=True)


def enter_namespace(descriptor: int) -> None:
    """setns(2). For a pid namespace it holds for children from now on. Raises OSError."""
    if _LIBC.setns(descriptor, 0) != 0:
        _fail()


def parent_namespace(descriptor: int) -> int:
    """A descriptor of the user namespace that this one was made in. Raises OSError."""
    return fcntl.ioctl(descriptor, _NS_GET_PARENT)


def process_control(option: int, value: int) -> None:
    """prctl(2) with one argument. Raises OSError."""
    if _LIBC.prctl(option, value, 0, 0, 0) != 0:
        _fail()


def drop_all_rights() -> None:
    """No program that is executed from now on can gain one. Takes a right of its own. Raises OSError."""
    for right in range(_MOST_RIGHTS):
        if _LIBC.prctl(PR_CAPBSET_DROP, right, 0, 0, 0) != 0:
            if ctypes.get_errno() != errno.EINVAL:
                _fail()
            return  # the kernel knows no more


class _Filter(ctypes.Structure):
    """struct sock_fprog."""

    _fields_ = (("length", ctypes.c_ushort), ("instructions", ctypes.c_char_p))


def filter_calls(instructions: bytes) -> None:
    """For this process and all that it starts, for good; see `system_calls`. Raises OSError.

    Nothing where the kernel was made without filters.
    """
    if not instructions:
        return
    given = _Filter(len(instructions) // 8, instructions)
    failed = _LIBC.prctl(PR_SET_SECCOMP, _SECCOMP_MODE_FILTER, ctypes.byref(given), 0, 0) != 0
    if failed and ctypes.get_errno() != errno.EINVAL:
        _fail()


@contextlib.contextmanager
def opened(path: str) -> Iterator[int]:
    descriptor = os.open(path, os.O_RDONLY | os.O_CLOEXEC)
    try:
        yield descriptor
    finally:
        os.close(descriptor)


def _fail() -> None:
    number = ctypes.get_errno()
    raise OSError(number, os.strerror(number))
