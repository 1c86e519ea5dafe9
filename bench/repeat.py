"""Many gradings of right and wrong programs under load: does any verdict differ from the quiet one?

For each exercise, a class hands in the solution, the alternatives, and the known mistakes in turn. The usual
`grade` command grades each of them once quietly, two at a time, and then GRADINGS in total with LOAD programs
at once: JOBS gradings, and busy loops for the rest. Each check is compared with the quiet grading of the same
files. All results are in the folder --keep: you can stop this at any moment, even with kill -9. The same
command then continues.
"""

from __future__ import annotations

import argparse
import contextlib
import multiprocessing
import os
import sqlite3
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from mixed import lay_variants, variants
from table import percentile, show

from course.batch.results import FILE

EXERCISES = ("18-publisher", "18-subscriber", "20-server", "20-client", "22-parameters")
# This many of each exercise in turn, with a table after each turn.
PORTION = 50
Checks = dict[str, str]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--exercises", nargs="+", default=EXERCISES)
    parser.add_argument("--gradings", type=int, default=2000, help="under load, of all exercises together")
    parser.add_argument("--load", type=int, default=10, help="programs at once, the gradings among them")
    parser.add_argument("--jobs", type=int, default=8, help="gradings at once under load")
    parser.add_argument("--right", action="store_true", help="only solutions and alternatives")
    parser.add_argument("--keep", type=Path, default=Path("repeated"), help="folder for all output")
    options = parser.parse_args()
    each = -(-options.gradings // len(options.exercises))
    quiet = {
        name: graded(
            name, options.keep / name / "quiet", len(variants(name, right=options.right)), 2, options.right
        )
        for name in options.exercises
    }
    for people in (*range(PORTION, each, PORTION), each):
        rows = []
        for name in options.exercises:
            with busy(options.load - options.jobs):
                folder = options.keep / name / f"load-{options.load}"
                rows.append(
                    row(
                        name,
                        quiet[name],
                        graded(name, folder, people, options.jobs, options.right),
                        options.right,
                    )
                )
        load = f"the machine's load is {os.getloadavg()[2]:.0f}"
        show(f"{options.load} programs at once, {options.jobs} of them gradings; {load}", HEAD, rows)


def graded(exercise: str, folder: Path, people: int, jobs: int, right: bool) -> sqlite3.Connection:
    """The results of a class of this size; only what is not in the folder yet is graded."""
    lay_variants(folder / "class", people, exercise, right=right)
    command = ["grade", str(folder / "class"), "--exercises", exercise, "--jobs", str(jobs)]
    subprocess.run(
        [sys.executable, "-m", "course", *command, "--out", str(folder / "grades")],
        cwd=Path(__file__).parents[1],
        check=False,  # failures and our errors are expected here
        stdout=subprocess.DEVNULL,
    )
    return sqlite3.connect(folder / "grades" / FILE)


HEAD = ("exercise", "gradings", "right", "wrong", "differ", "reruns", "our errors", "median (s)", "90% (s)")


def row(exercise: str, quiet: sqlite3.Connection, loaded: sqlite3.Connection, right: bool) -> list[str]:
    """Prints each grading that differs."""
    kinds = [f"{kind} {name}".strip() for kind, name in variants(exercise, right=right)]
    wanted, found = outcomes(quiet), outcomes(loaded)
    differing = 0
    for person, checks in sorted(found.items()):
        expected = wanted[f"p{int(person[1:]) % len(kinds):05}"]
        if checks != expected:
            differing += 1
            kind = kinds[int(person[1:]) % len(kinds)]
            print(f"{exercise} {person}, {kind}: {', '.join(changes(expected, checks))}")
    gradings = loaded.execute("SELECT verdict, attempt, seconds FROM gradings").fetchall()
    verdicts = Counter(verdict for verdict, _, _ in gradings)
    seconds = [taken for *_, taken in gradings]
    passing = sum(expected["verdict"] == "passed" for expected in wanted.values())
    return [
        exercise,
        str(len(gradings)),
        f"{passing} ways",
        f"{len(wanted) - passing} ways",
        str(differing),
        str(sum(attempt > 1 for _, attempt, _ in gradings)),
        str(verdicts["our error"]),
        f"{percentile(seconds, 0.5):.1f}",
        f"{percentile(seconds, 0.9):.1f}",
    ]


def changes(expected: Checks, found: Checks) -> list[str]:
    names = [name for name in expected.keys() | found.keys() if expected.get(name) != found.get(name)]
    return [f"{name}: {expected.get(name)} -> {found.get(name)}" for name in sorted(names)]


def outcomes(database: sqlite3.Connection) -> dict[str, Checks]:
    """By person: the verdict, and the outcome of each check."""
    gradings = database.execute("SELECT person, verdict FROM gradings")
    found: dict[str, Checks] = {person: {"verdict": verdict} for person, verdict in gradings}
    for person, check, outcome in database.execute("SELECT person, check_id, outcome FROM checks"):
        found[person][check] = outcome
    return found


@contextlib.contextmanager
def busy(processes: int) -> Iterator[None]:
    """Keep this many cores busy."""
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
    parent = os.getppid()
    while os.getppid() == parent:  # ends when its parent does, even if that is killed
        pass


if __name__ == "__main__":
    main()
