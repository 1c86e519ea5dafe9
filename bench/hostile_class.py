"""Honest submissions among hostile ones: does each honest one keep its marks, and does the machine survive?

Grades a class in which every eleventh submission is right and all others attack (tests/hostile/programs),
with the ordinary command. Compares files that anybody may write, processes, control groups and the
command's own memory before and after.
"""

from __future__ import annotations

import argparse
import resource
import sqlite3
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import psutil
from table import show

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT))

from course.batch.results import FILE  # noqa: E402 - the repository must be on the path
from course.content import open_course  # noqa: E402
from course.grading import trial  # noqa: E402
from tests.hostile.world import NODE, PROGRAMS, with_attack  # noqa: E402

EXERCISE = "18-publisher"
_PARTS = {"attempts", "beside"}
_GROUPS = Path("/sys/fs/cgroup")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--hostile", type=int, default=200)
    parser.add_argument("--honest", type=int, default=20)
    parser.add_argument("--jobs", type=int, default=4)
    given = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="ros2course-bench-") as name:
        folder = Path(name)
        honest = lay_class(folder / "class", given.hostile, given.honest)
        canary = folder / "canary"
        canary.write_text("untouched")
        canary.chmod(0o666)
        before, began = processes(), time.monotonic()
        command = ["grade", str(folder / "class"), "--exercises", EXERCISE, "--out", str(folder / "out")]
        command += ["--jobs", str(given.jobs)]
        done = subprocess.run(
            [sys.executable, "-m", "course", *command], cwd=ROOT, capture_output=True, text=True, check=False
        )
        minutes = (time.monotonic() - began) / 60
        marks = verdicts(folder / "out" / FILE)
        left = processes() - before
        kept = sum(marks.get(person) == "passed" for person in honest)
        rows = [
            ["submissions graded", f"{len(marks)} of {given.hostile + given.honest}"],
            ["honest ones with all points", f"{kept} of {len(honest)}"],
            ["our errors", str(sum(mark == "our error" for mark in marks.values()))],
            ["processes left behind", str(len(left))],
            ["control groups left behind", str(len(list(_GROUPS.glob("**/ros2course-*"))))],
            ["a file that anybody may write", canary.read_text()],
            ["rate", f"{len(marks) / minutes:.0f} a minute"],
            ["memory of the largest process of ours", f"{peak_of_children() / 1e6:.0f} MB"],
            ["exit code", str(done.returncode)],
        ]
    title = f"{given.honest} honest submissions among {given.hostile} hostile ones, {given.jobs} at once"
    show(title, ("what", "found"), rows)


def lay_class(folder: Path, hostile: int, honest: int) -> list[str]:
    """Lay out the class, and return the names of the honest submissions."""
    course = open_course()
    exercise = course.exercise(EXERCISE)
    attacks = sorted(file.stem for file in PROGRAMS.glob("*.py") if file.stem not in _PARTS)
    names = []
    for number in range(hostile + honest):
        right = number % (1 + hostile // max(honest, 1)) == 0 and len(names) < honest
        name = f"{'honest' if right else 'hostile'}-{number:03}"
        home = folder / name
        home.mkdir(parents=True)
        trial.lay_solution(course, exercise, home)
        if right:
            names.append(name)
        else:
            (home / NODE).write_text(with_attack(attacks[number % len(attacks)]), encoding="utf-8")
    return names


def verdicts(file: Path) -> dict[str, str]:
    with sqlite3.connect(file) as database:
        return dict(database.execute("SELECT person, verdict FROM gradings"))


def processes() -> set[tuple[int, float]]:
    """Processes of the course, and of the users that it gives to submissions."""
    found = set()
    for process in psutil.process_iter(["pid", "create_time", "uids", "cmdline"]):
        uids, words = process.info["uids"], " ".join(process.info["cmdline"] or ())
        if (uids and uids.real >= 2_000_000_000) or "course." in words:
            found.add((process.info["pid"], process.info["create_time"]))
    return found


def peak_of_children() -> float:
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024


if __name__ == "__main__":
    main()
