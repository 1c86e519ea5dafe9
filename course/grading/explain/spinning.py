"""Why callbacks are never called although everything they need was made: nothing spins the node."""

from __future__ import annotations

from course.evidence.sources import Sources
from course.feedback import Location
from course.grading.explain.python_code import calls, functions
from course.grading.explain.timers import Cause

SPINS = ("spin", "spin_once", "spin_until_future_complete")


def never_spun(sources: Sources) -> Cause | None:
    """No call of `rclpy.spin`, or one in a constructor: what comes after it there never happens."""
    spins = tuple(call.where for name in SPINS for call in calls(sources, name))
    if not spins:
        return Cause(
            "Nothing calls the callbacks: `main()` has to hand the node to `rclpy.spin(node)`, which "
            "waits and calls. A loop of your own does not."
        )
    early = [place for place in spins if _in_a_constructor(sources, place)]
    if not early:
        return None
    return Cause(
        "`rclpy.spin` comes back only at the end, so what `__init__` does after it is never done. "
        "Make the whole node first, and spin it in `main()`.",
        tuple(early),
    )


def _in_a_constructor(sources: Sources, place: Location) -> bool:
    alone = Sources({place.file: sources.files[place.file]})
    found = functions(alone, "__init__")
    return any(node.lineno <= (place.line or 0) <= (node.end_lineno or 0) for node in found)
