"""bubblewrap's arguments for the inner layer."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from course.arena.sandbox.plan import Plan

_NAMESPACES = "--die-with-parent --unshare-pid --unshare-ipc --unshare-uts --hostname robot".split()
# Inside, the only user that is not root. In a namespace of users there can be no others below.
_USER = "--unshare-user --uid 1000 --gid 1000 --disable-userns".split()
_SYSTEM = ("/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32")
# What programs look up there, and nothing that tells of this machine or its users.
_ETC = (
    "alternatives bash.bashrc bash_completion.d default/locale inputrc ld.so.cache ld.so.conf ld.so.conf.d "
    "locale.alias localtime lsb-release mime.types nsswitch.conf os-release profile profile.d protocols "
    "python3 python3.10 python3.11 python3.12 python3.13 services shells skel ssl/certs ssl/openssl.cnf "
    "terminfo timezone"
).split()
TEMPORARY = 64 * 1024 * 1024


def arguments(plan: Plan, writable: Sequence[Path], texts: Sequence[tuple[int, str]] = ()) -> tuple[str, ...]:
    """For bwrap: namespaces, and what is to be seen in them. What is not named here is not there.

    writable: folders. texts: descriptors that the text of a file of that name is read from.
    """
    return (
        *_NAMESPACES,
        *(() if plan.user is not None else _USER),
        *("--proc", "/proc", "--dev", "/dev"),
        *("--perms", "1777", "--size", str(TEMPORARY), "--tmpfs", "/tmp"),
        *("--perms", "1777", "--size", str(TEMPORARY), "--tmpfs", "/dev/shm"),
        *_system(),
        *_mounts("--ro-bind-try", (path for path in plan.shown if not _within(path, plan.hidden))),
        *(word for path in plan.hidden for word in ("--tmpfs", path)),
        *_mounts("--ro-bind-try", (path for path in plan.shown if _within(path, plan.hidden))),
        *_mounts("--bind", (str(path) for path in writable)),
        *(word for number, name in texts for word in ("--perms", "644", "--ro-bind-data", str(number), name)),
        # What all of this is put into is memory without a bound, and belongs to whoever is root in there.
        *(word for path in ("/", "/dev", *plan.hidden) for word in ("--remount-ro", path)),
    )


def _mounts(how: str, paths: Iterable[str]) -> Iterator[str]:
    for path in paths:
        # Else bubblewrap makes a way there that only root can go.
        yield from ("--dir", str(Path(path).parent), how, path, path)


def _within(path: str, folders: Iterable[str]) -> bool:
    return any(Path(path).is_relative_to(folder) for folder in folders)


def _system() -> Iterator[str]:
    for name in _SYSTEM:
        path = Path(name)
        if path.is_symlink():
            yield from ("--symlink", str(path.readlink()), name)
        elif path.is_dir():
            yield from ("--ro-bind", name, name)
    yield from ("--dir", "/etc")
    for name in _ETC:
        if Path("/etc", name).exists():
            yield from ("--ro-bind", f"/etc/{name}", f"/etc/{name}")


def users(plan: Plan) -> tuple[tuple[str, str], ...]:
    """Names and texts of the files that tell of users and machines: the same everywhere."""
    number = 1000 if plan.user is None else plan.user
    return (
        ("/etc/passwd", f"root:x:0:0:root:/root:/bin/bash\nlearner:x:{number}:{number}::/:/bin/bash\n"),
        ("/etc/group", f"root:x:0:\nlearner:x:{number}:\n"),
        ("/etc/hosts", "127.0.0.1 localhost robot\n::1 localhost\n"),
    )


@contextlib.contextmanager
def data(text: str | bytes) -> Iterator[int]:
    """A descriptor that bubblewrap can read the text from, once."""
    descriptor = os.memfd_create("text")
    try:
        os.write(descriptor, text if isinstance(text, bytes) else text.encode())
        os.lseek(descriptor, 0, os.SEEK_SET)
        yield descriptor
    finally:
        os.close(descriptor)
