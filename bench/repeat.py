"""Fifty checks of a right solution in a row, quiet and with all cores kept busy.

Every verdict that is not «passed» is printed with its reason.
"""

from __future__ import annotations

import argparse
import contextlib
import multiprocessing
import os
import time
from collections import Counter
from collections.abc import Iterator

from solved import solved
from table import show, spread

from course.grading.check import check_exercise
from course.grading.result import Outcome, Result
from course.rosenv import find_ros


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--exercise", default="18-publisher")
    parser.add_argument("--rounds", type=int, default=50)
    parser.add_argument("--domain", action="store_true", help="without namespaces")
    options = parser.parse_args()
    rows = []
    for name, load in (("quiet", 0), ("busy", os.cpu_count() or 1)):
        with busy(load):
            rows.append([name, *checked(options.exercise, options.rounds, namespaces=not options.domain)])
    head = ("machine", "passed", "not passed", "our error", "median", "90 %", "slowest")
    show(f"{options.rounds} checks of the right {options.exercise} (s)", head, rows)


def checked(exercise_id: str, rounds: int, *, namespaces: bool) -> list[str]:
    verdicts: Counter[str] = Counter()
    taken = []
    with solved(exercise_id) as (exercise, home):
        for number in range(rounds):
            began = time.monotonic()
            result = check_exercise(exercise, home, ros=find_ros(), namespaces=namespaces)
            taken.append(time.monotonic() - began)
            verdicts[result.verdict.value] += 1
            explain(number, result)
    return [str(verdicts[name]) for name in ("passed", "not passed", "our error")] + spread(taken)


def explain(number: int, result: Result) -> None:
    for check in result.checks:
        if check.outcome is not Outcome.PASSED:
            why = check.feedback or check.skipped_because
            print(f"round {number}: {check.id} {check.outcome.value}: {why}")
    if result.fault:
        print(f"round {number}: {result.fault}")


@contextlib.contextmanager
def busy(processes: int) -> Iterator[None]:
    """Keep that many cores busy."""
    started = [multiprocessing.Process(target=burn, daemon=True) for _ in range(processes)]
    for process in started:
        process.start()
    try:
        yield
    finally:
        for process in started:
            process.kill()
            process.join()


def burn() -> None:
    while True:
        pass


if __name__ == "__main__":
    main()
