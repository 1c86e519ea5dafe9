"""System calls that Python has no function for.

Source: setns(2), unshare(2), mount(2), prctl(2), seccomp(2), ioctl_ns(2); devpts in the kernel's documents.
"""

from __future__ import annotations

import contextlib
import ctypes
import errno
import fcntl
import os
from collections.abc import Iterable, Iterator

PR_SET_DUMPABLE = 4
PR_SET_SECCOMP = 22
PR_CAPBSET_DROP = 24
PR_SET_NO_NEW_PRIVS = 38
_SECCOMP_MODE_FILTER = 2
_MOST_RIGHTS = 64
_NS_GET_PARENT = 0xB702
_CLONE_NEWNS = 0x0002_0000
_MS_NOSUID_NODEV, _MS_PRIVATE_BELOW, _MS_BIND_BELOW = 0x2 | 0x4, 0x4_0000 | 0x4000, 0x1000 | 0x4000
_MS_TERMINALS = 0x20 | 0x2 | 0x8  # a remount; nosuid and noexec, as in bubblewrap
_MOST_FILES = 1024
_LIBC = ctypes.CDLL(None, use_errno=True)


def enter_namespace(descriptor: int) -> None:
    """setns(2). A pid namespace applies to future children only. Raises OSError."""
    if _LIBC.setns(descriptor, 0) != 0:
        _fail()


def parent_namespace(descriptor: int) -> int:
    """A descriptor of the user namespace in which this one was made. Raises OSError."""
    return fcntl.ioctl(descriptor, _NS_GET_PARENT)


def mount_memory(folder: str, size: int, kept: Iterable[str]) -> None:
    """Mount a file system of `size` bytes there, for this process and its children only.

    kept: folders below it that stay as they are; otherwise it is empty. Needs the right to mount in its
    namespace. Raises OSError.
    """
    if _LIBC.unshare(_CLONE_NEWNS) != 0:
        _fail()
    _mount(None, "/", _MS_PRIVATE_BELOW)
    with contextlib.ExitStack() as stack:
        before = {path: stack.enter_context(opened(path)) for path in kept}
        _mount("tmpfs", folder, _MS_NOSUID_NODEV, f"mode=1777,size={size},nr_inodes={_MOST_FILES}")
        for path, descriptor in before.items():
            os.makedirs(path)  # noqa: PTH103 - a path as mount(2) takes it
            _mount(f"/proc/self/fd/{descriptor}", path, _MS_BIND_BELOW)


def bound_terminals(folder: str, most: int) -> None:
    """Limit how many pseudo-terminals that file system offers at a time; otherwise it offers the machine's.

    Needs the right to mount in its namespace. Raises OSError.
    """
    _mount(None, folder, _MS_TERMINALS, f"mode=620,ptmxmode=666,max={most}")


def _mount(what: str | None, where: str, flags: int, options: str = "") -> None:
    given = what.encode() if what else None
    if _LIBC.mount(given, where.encode(), given, flags, options.encode() or None) != 0:
        _fail()


def process_control(option: int, value: int) -> None:
    """prctl(2) with one argument. Raises OSError."""
    if _LIBC.prctl(option, value, 0, 0, 0) != 0:
        _fail()


def drop_all_rights() -> None:
    """Drop all rights: no program executed from now on can gain one. This needs a right. Raises OSError."""
    for right in range(_MOST_RIGHTS):
        if _LIBC.prctl(PR_CAPBSET_DROP, right, 0, 0, 0) != 0:
            if ctypes.get_errno() != errno.EINVAL:
                _fail()
            return  # the kernel has no rights with higher numbers


class _Filter(ctypes.Structure):
    """struct sock_fprog."""

    _fields_ = (("length", ctypes.c_ushort), ("instructions", ctypes.c_char_p))


def filter_calls(instructions: bytes) -> None:
    """Filter calls of this process and everything that it starts, forever; see `system_calls`.

    Does nothing if the kernel was built without filters. Raises OSError.
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
