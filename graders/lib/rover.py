"""What the rover's chapters share: its names, how fast it may drive, and whether a controller obeys."""

from __future__ import annotations

import secrets
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from course.api import (
    Arena,
    Cause,
    Failure,
    Feedback,
    OurFault,
    Process,
    Recording,
    never_called,
    slips,
    text_places,
    without_effect,
)

if TYPE_CHECKING:
    from course.api import Listener

PACKAGE = "rover"
LIBRARY = f"{PACKAGE}.driving"
RANGE, RANGE_TYPE = "/rover/range", "sensor_msgs/msg/Range"
COMMAND, COMMAND_TYPE = "/rover/cmd_vel", "geometry_msgs/msg/Twist"
STOP, STOP_TYPE = "/rover/stop", "std_srvs/srv/SetBool"
SENSOR, CONTROLLER = "range_sensor", "controller"
STOP_AT = FULL_SPEED = 0.5
CLOSE = 1e-3  # m or m/s; messages contain distances as float32


def safe_speed(distance: float, stop_at: float = STOP_AT, full_speed: float = FULL_SPEED) -> float:
    """The speed that the task of chapter 14 asks for (m/s), for distances in m."""
    return min(full_speed, max(0.0, distance - stop_at))


def distances() -> list[float]:
    """Far, near, too near, and far again. The second one is random."""
    return [4.0, 0.6 + secrets.randbelow(30) / 100, 0.3, 2.0]


def measure(
    arena: Arena, publish: Callable[..., None], commands: Listener, node: Process, *measured: float
) -> None:
    """Publish each distance, and wait for the command that follows it."""
    for distance in measured:
        before = commands.count
        publish(range=distance)
        arena.until(partial(more_commands, commands, before), timeout=1.5, while_running=node)


def more_commands(commands: Listener, number: int) -> bool:
    return commands.count > number


def answered_distances(recording: Recording, begin: float, end: float) -> list[tuple[float, float | None]]:
    """Each distance (m) measured in this time, with the last speed (m/s) commanded after it."""
    found = []
    for reaction in recording.reactions(RANGE):
        if begin <= reaction.to.t < end:
            after = [m for m in reaction.topic(COMMAND).messages if m.t < end]
            found.append((float(reaction.to.data.range), after[-1].data.linear.x if after else None))
    if not found:
        raise OurFault("the scenario measured no distance here")
    return found


def expect_speed(
    recording: Recording, distance: float, speed: float | None, wanted: float, advice: str
) -> None:
    """Check the speed (m/s) that followed a distance (m)."""
    if speed is not None and abs(speed - wanted) <= CLOSE:
        return
    if speed is None:
        advice = "Publish a `Twist` in `range_callback`, once for each measurement."
    cause = slips.first(
        recording.sources, slips.compared, without_effect, *([never_called] if speed is None else [])
    )
    cause = cause or Cause(advice, text_places(recording.sources, "linear.x")[:1])
    raise Failure(
        Feedback(
            summary=f"At a distance of {distance:.2f} m, the speed is wrong."
            if speed is not None
            else f"At a distance of {distance:.2f} m, there is no command.",
            expected=f"linear.x is {wanted:.2f}",
            seen="no command" if speed is None else f"linear.x is {speed:.2f}",
            where=cause.where,
            advice=cause.text,
        )
    )
