"""Processes and what they have started, as Linux tells it.

Without pathlib and contextlib: the guard would spend most of its time on them, and it has to be quick on a
machine that has much else to do.
"""
# ruff: noqa: PTH115, PTH123, PTH208

from __future__ import annotations

import os
from collections.abc import Iterable


def descendants(roots: Iterable[int]) -> list[int]:
    """All processes below `roots`, without these; none where there is no /proc."""
    children: dict[int, list[int]] = {}
    for pid in _processes():
        children.setdefault(_parent(pid), []).append(pid)
    found, waiting = [], list(roots)
    while waiting:
        below = children.get(waiting.pop(), [])
        found += below
        waiting += below
    return found


def holders(target: str) -> list[int]:
    """All processes that have `target` open, as /proc calls it."""
    return [pid for pid in _processes() if _holds(f"/proc/{pid}/fd", target)]


def _processes() -> list[int]:
    try:
        return [int(name) for name in os.listdir("/proc") if name.isdecimal()]
    except OSError:
        return []


def _parent(pid: int) -> int:
    """0 for one that has ended."""
    try:
        with open(f"/proc/{pid}/stat", "rb") as file:
            return int(file.read().rpartition(b")")[2].split()[1])
    except (OSError, ValueError, IndexError):
        return 0


def _holds(files: str, target: str) -> bool:
    try:
        return any(_is_link_to(f"{files}/{number}", target) for number in os.listdir(files))
    except OSError:  # it has ended, or is somebody else's
        return False


def _is_link_to(file: str, target: str) -> bool:
    try:
        return os.readlink(file) == target
    except OSError:
        return False
