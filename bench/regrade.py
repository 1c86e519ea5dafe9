"""How long it takes to judge a thousand stored recordings again, and whether the verdicts stay the same.

Solutions and known mistakes of different exercises are graded once, and their recordings are copied to a
thousand files. The baseline loads these files and judges nothing. The mistakes take longer than the solutions
because of their explanations; 50 ms are allowed.
"""

from __future__ import annotations

import argparse
import os
import resource
import shutil
import tempfile
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import cycle, islice
from pathlib import Path

from table import show
from whole_course import homes

from course.content import Exercise, Mistake, open_course
from course.evidence.mcap_file import load
from course.grading import trial
from course.grading.check import Request, check_exercise
from course.grading.judge.judges import StoredRecording, rejudge
from course.grading.judge.regraded import lacks, moves, regraded
from course.grading.protocol import Unjudged
from course.grading.trial_answers import SEED
from course.model.result import Result, Verdict
from course.rosenv import find_ros

EXERCISES = """
    01-files 02-script 02-class 08-template-node 12-print-forever 14-library 18-publisher 18-subscriber
    19-inspect-topics 20-server 20-client 22-parameters 22-launch 24-inspect-parameters
""".split()
MB = 1024.0  # the unit of getrusage


class Kept:
    """One grading: its result and its recording."""

    def __init__(self, exercise: Exercise, home: Path, evidence: Path) -> None:
        self.exercise, self.home, self.evidence = exercise, home, evidence
        request = Request(exercise, home, ros=find_ros(), seed=SEED, evidence=evidence)
        self.result: Result = check_exercise(request)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--recordings", type=int, default=1000)
    parser.add_argument("--mistakes", type=int, default=1, help="of each exercise")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="processes at once")
    parser.add_argument("only", nargs="*", default=EXERCISES, help="these exercises")
    given = parser.parse_args()
    with homes(given.only) as solved, tempfile.TemporaryDirectory(prefix="ros2course-bench-") as folder:
        kept = recorded(solved, given.mistakes, Path(folder))
        stored = copies(kept, given.recordings, Path(folder, "copies"))
        size = sum(one.file.stat().st_size for one in stored) / len(stored)
        verdicts = ", ".join(sorted({one.result.verdict.value for one in kept}))
        print(f"{len(kept)} gradings ({verdicts}) of {len(solved)} exercises; {size / 1024:.0f} kB each")
        floor = timed(lambda: loaded(stored))
        rows = [row("only loaded, one process", floor, floor, len(stored))]
        for jobs in sorted({1, given.jobs}):
            taken = timed(lambda jobs=jobs: judged(stored, jobs))
            rows.append(row(f"judged again, {jobs} at once", taken, floor, len(stored)))
        for name, passed in (("solutions", True), ("mistakes", False)):
            some = [one for one in stored if (one.key.result.verdict is Verdict.PASSED) is passed]
            taken = timed(lambda some=some: judged(some, 1))
            rows.append(row(f"{name}, 1 at once", taken, floor * len(some) / len(stored), len(some)))
    show(f"{given.recordings} recordings", ("what", "s", "ms each", "x floor"), rows)
    own, workers = (resource.getrusage(who).ru_maxrss / MB for who in (_SELF, _CHILDREN))
    print(f"\nmost memory: {own:.0f} MB here, {workers:.0f} MB in the largest child (gradings included)")


_SELF, _CHILDREN = resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN


def recorded(solved: list[tuple[Exercise, Path]], mistakes: int, folder: Path) -> list[Kept]:
    """The right solution of each exercise, and then `mistakes` of its mistakes in files or acts."""
    chosen = [(exercise, one) for exercise, _ in solved for one in some_mistakes(exercise, mistakes)]
    with ThreadPoolExecutor(2) as pool:
        right = list(pool.map(lambda one: Kept(*one, folder / f"{one[0].id}.mcap"), solved))
        wrong = list(pool.map(lambda one: mistaken(*one, folder), chosen))
    return right + wrong


def some_mistakes(exercise: Exercise, count: int) -> list[Mistake]:
    """`count` mistakes, evenly chosen from all of them."""
    found = [one for one in exercise.mistakes() if all(edit.answers is None for edit in one.edits)]
    return found[:: max(1, len(found) // count)][:count]


def mistaken(exercise: Exercise, mistake: Mistake, folder: Path) -> Kept:
    name = f"{exercise.id} {mistake.id}"
    home = folder / name
    home.mkdir()
    trial.lay_solution(open_course(), exercise, home)
    trial.apply_mistake(exercise, mistake, home)
    return Kept(exercise, home, folder / f"{name}.mcap")


def copies(kept: list[Kept], count: int, folder: Path) -> list[StoredRecording[Kept]]:
    folder.mkdir()
    stored = []
    for number, one in enumerate(islice(cycle(kept), count)):
        file = folder / f"{number}.mcap"
        shutil.copy(one.evidence, file)
        stored.append(StoredRecording(one, one.exercise, file))
    return stored


def loaded(stored: list[StoredRecording[Kept]]) -> None:
    for one in stored:
        load(one.file)


def judged(stored: list[StoredRecording[Kept]], jobs: int) -> None:
    """End the benchmark if a verdict has changed, or if a recording counts as incomplete."""
    count = 0
    for kept, answer in rejudge(stored, jobs=jobs):
        if isinstance(answer, Unjudged):
            raise SystemExit(f"{kept.evidence.name}: {answer}")
        after = regraded(kept.result, kept.exercise, answer.judgment, kept.home, SEED)
        moved, lack = moves(kept.result, after), lacks(kept.result, after, answer)
        if moved or lack or after.verdict is not kept.result.verdict:
            raise SystemExit(f"{kept.evidence.name}: {after.verdict.value}: {lack} {moved}")
        count += 1
    assert count == len(stored)


def timed(work: Callable[[], None]) -> float:
    began = time.monotonic()
    work()
    return time.monotonic() - began


def row(name: str, taken: float, floor: float, count: int) -> list[str]:
    return [name, f"{taken:.2f}", f"{taken / count * 1000:.2f}", f"{taken / floor:.1f}"]


if __name__ == "__main__":
    main()
