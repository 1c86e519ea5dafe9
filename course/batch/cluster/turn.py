"""Who may use a machine's processors: several gradings together, or one with nothing beside it."""

from __future__ import annotations

import contextlib
import fcntl
from collections.abc import Iterator
from pathlib import Path

from course.rosenv.files import locked


@contextlib.contextmanager
def turn(gate: Path, *, alone: bool) -> Iterator[None]:
    """Waits until this grading may run. gate: a file that all workers of the machine share.

    Who waits to be alone lets nobody past meanwhile. A process that dies lets go of it.
    """
    gate.parent.mkdir(parents=True, exist_ok=True)
    with gate.open("a", encoding="utf-8") as place:
        with locked(gate.with_name(f"{gate.name}.next")):
            fcntl.flock(place, fcntl.LOCK_EX if alone else fcntl.LOCK_SH)
        yield
