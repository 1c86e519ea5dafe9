"""From when on a program's end has to do with what it was sent."""

from __future__ import annotations

from collections.abc import Iterable
from math import inf

from course.evidence.recording import Recording

# The file of rclpy through which every callback is called.
_EXECUTOR = "rclpy/executors.py"


def first_reaction(recording: Recording, process: str, sent: Iterable[float]) -> float:
    """When the first of these was sent, if the program did anything at all after it; else for ever.

    sent: times (s) of messages or calls. A node that is never spun ends by itself too, or by an
    exception, at a moment that has nothing to do with what it is sent.
    """
    traceback = recording.process(process).traceback()
    if traceback and not any(_EXECUTOR in line for line in traceback):
        return inf
    first = min(sent, default=inf)
    shown = (line.t for line in recording.process(process).lines)
    logged = (line.t for line in recording.log)
    return first if any(t >= first for t in (*shown, *logged)) else inf
