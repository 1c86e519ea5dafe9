"""A mystery's nodes in an arena, among the learner's programs but on the course's own ROS."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from course.arena.play import START_TIME, job_line, own_path, player_command
from course.arena.process import Process
from course.errors import OurFault
from course.evidence.acts import MYSTERY
from course.evidence.events import OutputLine

if TYPE_CHECKING:
    from course.arena.arena import Arena

READY = "ready"
# The arena's own values for these stay.
_ARENAS = frozenset({"HOME", "TMPDIR", "ROS_LOG_DIR", "TERM"})


def play_here(arena: Arena, file: Path) -> Process:
    """Raises OurFault when there is no seed to draw from, and when the nodes do not come up."""
    if arena.seed is None:
        raise OurFault(f"no seed was given to draw {file.stem} from")
    own = our_environment()
    process = arena.start_ours(*player_command(), name=MYSTERY, env={**own, "PYTHONPATH": own_path(own)})
    process.type(job_line(file, file.stem, arena.seed, None))
    if not arena.until(lambda: READY in _printed(arena), timeout=START_TIME, while_running=process):
        raise OurFault(f"the mystery's nodes did not come up: {' | '.join(_printed(arena)[-5:])}")
    return process


def our_environment() -> dict[str, str]:
    """Of this process, for programs of the course's own that run beside the learner's."""
    return {name: value for name, value in os.environ.items() if name not in _ARENAS}


def _printed(arena: Arena) -> list[str]:
    return [event.text for event in arena.timeline.of(OutputLine) if event.process == MYSTERY]
