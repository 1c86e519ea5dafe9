"""The time that containment adds to a check: one exercise, alternately contained and in its own ROS domain.

The exercise is a script that prints a line, without ROS, so that little else is timed. Opening and closing
are also timed separately, from outside.
"""

from __future__ import annotations

import argparse
import subprocess
import time
from collections.abc import Callable
from pathlib import Path
from statistics import median

from solved import solved
from table import show, spread

from course.content import Exercise
from course.grading.check import Request, check_exercise
from course.isolation import Level
from course.isolation.levels import MachinePlaces, isolated, obstacle_to
from course.rosenv import find_ros

EXERCISE = "02-script"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=20)
    parser.add_argument("--exercise", default=EXERCISE)
    given = parser.parse_args()
    with solved(given.exercise) as (exercise, home):
        once(exercise, home, True)
        taken = {kind: [] for kind in (True, False)}
        for _ in range(given.rounds):
            for kind, times in taken.items():
                times.append(once(exercise, home, kind))
    with_it, without = taken[True], taken[False]
    rows = [
        ["without (a ROS domain)", *spread(without), "0.000"],
        ["contained", *spread(with_it), f"{median(with_it) - median(without):.3f}"],
        *parts(given.rounds),
    ]
    show(f"A check of {given.exercise} (s)", ("what", "median", "90 %", "slowest", "more"), rows)


def once(exercise: Exercise, home: Path, contained: bool) -> float:
    began = time.monotonic()
    result = check_exercise(Request(exercise, home, ros=find_ros(), namespaces=contained))
    taken = time.monotonic() - began
    expected = "contained" if contained else "domain"
    if (result.verdict.value, result.containment) != ("passed", expected):
        raise SystemExit(f"{result.verdict.value}, {result.containment}: {result.notes} {result.fault}")
    return taken


def parts(rounds: int) -> list[list[str]]:
    def opened() -> None:
        with isolated(MachinePlaces()) as place:
            subprocess.run([*place.prefix, "/bin/true"], check=True)

    timed: dict[str, Callable[[], object]] = {
        "  looking whether it can be had": lambda: obstacle_to(Level.CONTAINED),
        "  opening and closing the outer layer, with that": opened,
    }
    return [[name, *spread([clock(work) for _ in range(rounds)]), ""] for name, work in timed.items()]


def clock(work: Callable[[], object]) -> float:
    began = time.monotonic()
    work()
    return time.monotonic() - began


if __name__ == "__main__":
    main()
