"""Links that are put in place in one step, whether or not one is there already."""

from __future__ import annotations

import os
from pathlib import Path


def link(place: Path, target: Path) -> None:
    """Make `place` a link to `target`; who looks at it sees the old one or the new one, never none."""
    place.parent.mkdir(parents=True, exist_ok=True)
    beside = place.with_name(f".{place.name}.{os.getpid()}")
    beside.unlink(missing_ok=True)
    beside.symlink_to(target)
    beside.replace(place)
