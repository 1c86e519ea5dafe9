"""Grades all reference solutions, quietly or with all cores busy: does a verdict change?

The baseline is the time that the checks watch: programs run as long as their evidence takes, two at once.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import tempfile
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from repeat import busy
from table import show

from course.content import Exercise, open_course
from course.grading import trial
from course.grading.check import Request, check_exercise
from course.grading.trial_answers import SEED
from course.home import create_home
from course.model.result import Outcome, Result, Verdict
from course.rosenv import find_ros


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--goes", type=int, default=3, help="how often all are graded")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="gradings at once")
    parser.add_argument("--busy", action="store_true", help="keep all cores busy meanwhile")
    parser.add_argument(
        "--each", action="store_true", help="one at a time: what each takes beyond its evidence"
    )
    parser.add_argument("only", nargs="*", help="these exercises only")
    options = parser.parse_args()
    with homes(options.only) as solved, busy(os.cpu_count() or 1 if options.busy else 0):
        graded(solved, options.jobs)  # builds everything that is not built yet
        if options.each:
            show(
                "Checks with nothing to rebuild (s)", ("exercise", "watched", "whole", "beyond"), each(solved)
            )
            return
        goes = [go(number, solved, options.jobs) for number in range(options.goes)]
    head = ("go", "passed", "not passed", "our error", "watched (s)", "whole (s)", "x floor")
    show(f"{len(solved)} solutions, {options.jobs} at once", head, goes)
    slowest = max(goes, key=lambda row: float(row[5]))
    print(f"\nslowest go: {slowest[5]} s")


def explain(number: int, result: Result) -> None:
    for check in result.checks:
        if check.outcome is not Outcome.PASSED:
            why = check.feedback or check.skipped_because
            print(f"round {number}: {check.id} {check.outcome.value}: {why}")
    if result.fault:
        print(f"round {number}: {result.fault}")


def go(number: int, solved: list[tuple[Exercise, Path]], jobs: int) -> list[str]:
    began = time.monotonic()
    results = graded(solved, jobs)
    whole = time.monotonic() - began
    for result in results:
        if result.verdict is not Verdict.PASSED:
            print(f"{result.exercise}:")
            explain(number, result)
    verdicts = [sum(r.verdict is verdict for r in results) for verdict in _VERDICTS]
    watched = sum(result.timing.evidence for result in results)
    figures = [f"{watched:.1f}", f"{whole:.1f}", f"{whole / (watched / jobs):.2f}"]
    return [str(number), *map(str, verdicts), *figures]


_VERDICTS = (Verdict.PASSED, Verdict.NOT_PASSED, Verdict.OUR_ERROR)


def each(solved: list[tuple[Exercise, Path]]) -> list[list[str]]:
    """One row per exercise, in one process, without the start of the command itself (`commands.py`)."""
    rows = []
    for one in solved:
        began = time.monotonic()
        (result,) = graded([one], 1)
        whole, watched = time.monotonic() - began, result.timing.evidence
        rows.append([result.exercise, *(f"{figure:.2f}" for figure in (watched, whole, whole - watched))])
    return sorted(rows, key=lambda row: -float(row[3]))


def graded(solved: list[tuple[Exercise, Path]], jobs: int) -> list[Result]:
    ros = find_ros()
    with ThreadPoolExecutor(jobs) as pool:
        return list(pool.map(lambda one: check_exercise(Request(*one, ros=ros, seed=SEED)), solved))


@contextlib.contextmanager
def homes(only: list[str]) -> Iterator[list[tuple[Exercise, Path]]]:
    """A course home with the reference solution for each exercise that files can solve."""
    course = open_course()
    chosen = [e for e in course.exercises() if not e.local_only and (not only or e.id in only)]
    with tempfile.TemporaryDirectory(prefix="ros2course-bench-") as folder:
        solved = [(exercise, create_home(Path(folder, exercise.id)).path) for exercise in chosen]
        for exercise, home in solved:
            trial.lay_solution(course, exercise, home)
        yield solved


if __name__ == "__main__":
    main()
