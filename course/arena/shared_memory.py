"""Which shared memory a program uses, as the kernel tells it."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path

import psutil

_FOLDER = "/dev/shm/"
_DELETED = " (deleted)"


def files_in_memory(pid: int) -> tuple[str, ...]:
    """Names of the files in /dev/shm that this process, or one below it, has in its memory now; sorted."""
    return tuple(sorted({name for process in _tree(pid) for name in _mapped(process)}))


def _tree(pid: int) -> list[int]:
    try:
        below = psutil.Process(pid).children(recursive=True)
    except psutil.NoSuchProcess:
        return []
    return [pid, *(process.pid for process in below)]


def _mapped(pid: int) -> Iterator[str]:
    with contextlib.suppress(FileNotFoundError, ProcessLookupError):  # it has just ended
        for line in Path(f"/proc/{pid}/maps").read_text(encoding="utf-8", errors="replace").splitlines():
            _, _, file = line.partition(_FOLDER)
            if file:
                yield file.removesuffix(_DELETED)
