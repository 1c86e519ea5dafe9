"""Made-up streams of a driver, drawn from a seed, on a quiet or a busy machine."""

from __future__ import annotations

import math
import random
from collections.abc import Callable

from course.evidence.stream import Row, Stream

JOINTS = 6


def ticks(seed: int, period: float, seconds: float, *, jitter: float = 0.0, drop: float = 0.0) -> list[float]:
    """Times at an even pace, each late by up to `jitter` of the period, and some of them missing."""
    chance = random.Random(seed)
    due = (place * period for place in range(round(seconds / period) + 1))
    return [t + chance.random() * jitter * period for t in due if chance.random() >= drop]


def held_up(times: list[float], begin: float, until: float) -> list[float]:
    """The times as seen by a receiver that was blocked from `begin` to `until`: these came all at once."""
    return [max(t, until) if t >= begin else t for t in times]


def following(times: list[float], where: Callable[[float], Row], name: str = "/arm/states") -> Stream:
    return Stream(name, tuple(times), tuple(where(t) for t in times))


def swing(frequency: float = 1.0, late: float = 0.0, share: float = 1.0) -> Callable[[float], Row]:
    """A different amplitude, phase, and place for each joint."""

    def where(t: float) -> Row:
        turn = math.tau * frequency * (t - late)
        return tuple(
            0.1 * joint + share * 0.2 * (joint + 1) * math.sin(turn + 0.5 * joint) for joint in range(JOINTS)
        )

    return where


def steps(sent: list[float], late: float = 0.0) -> Callable[[float], Row]:
    """At zero; then, each `late` seconds after it was sent, at the n-th target."""

    def where(t: float) -> Row:
        return target(sum(1 for moment in sent if t >= moment + late))

    return where


def target(number: int) -> Row:
    return tuple(0.1 * number * (joint + 1) for joint in range(JOINTS))
