"""Processes and what they have started, as Linux tells it."""

from __future__ import annotations

import contextlib
from collections.abc import Iterable
from pathlib import Path


def descendants(roots: Iterable[int]) -> list[int]:
    """All processes below `roots`, without these; none where there is no /proc."""
    children: dict[int, list[int]] = {}
    for folder in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError, ValueError, IndexError):
            parent = int((folder / "stat").read_text(encoding="utf-8").rpartition(")")[2].split()[1])
            children.setdefault(parent, []).append(int(folder.name))
    found, waiting = [], list(roots)
    while waiting:
        below = children.get(waiting.pop(), [])
        found += below
        waiting += below
    return found


def holders(target: str) -> list[int]:
    """All processes that have `target` open, as /proc calls it."""
    return [int(folder.name) for folder in Path("/proc").glob("[0-9]*") if _holds(folder, target)]


def _holds(process: Path, target: str) -> bool:
    with contextlib.suppress(OSError):  # it has ended, or is somebody else's
        return any(_is_link_to(file, target) for file in (process / "fd").iterdir())
    return False


def _is_link_to(file: Path, target: str) -> bool:
    with contextlib.suppress(OSError):
        return str(file.readlink()) == target
    return False
