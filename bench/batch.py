"""Grades a class with `grade`, and a sample of it with `check`, one after another.

Right solutions and known mistakes alternate. Half of the sample is checked before the class is graded and
half afterwards, so that a busy machine affects both equally. Each has its own build cache, which contains
only the reference solution.

    .venv/bin/python bench/batch.py                     100 submissions of 18-publisher
    .venv/bin/python bench/batch.py --jobs 2,4,6 --people 24 --sample 0
    .venv/bin/python bench/batch.py --sizes 20,100,500 --exercise 07-simplest-package --sample 0
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
import threading
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import psutil
from mixed import lay_mixed
from table import show

from course.batch.results import Results
from course.batch.run import default_jobs
from course.model.result import Outcome, Result, from_json

ROOT = Path(__file__).parents[1]
MB = 1024 * 1024
LOOK_EVERY = 0.1
RECORDING = "course.grading.recording_process"
ROLES = (
    ("course.batch.worker", "worker"),
    (RECORDING, "recording"),
    ("course.grading.judge.judging_process", "judging"),
)

Judged = tuple[str, frozenset[str]]


@dataclass
class Peaks:
    """The most memory that one process of each role used, in bytes; and their CPU time, in seconds."""

    memory: Counter[str] = field(default_factory=Counter)
    cpu: dict[tuple[int, float], tuple[str, float]] = field(default_factory=dict)

    def look(self, top: psutil.Process) -> None:
        for process in [top, *top.children(recursive=True)]:
            with contextlib.suppress(psutil.Error):
                role = "coordinator" if process == top else _role(process)
                self.memory[role] = max(self.memory[role], process.memory_info().rss)
                times = process.cpu_times()
                self.cpu[process.pid, process.create_time()] = (role, times.user + times.system)

    def seconds(self, role: str) -> float:
        return sum(used for of, used in self.cpu.values() if of == role)


@dataclass(frozen=True)
class Go:
    """One command. gradings: verdicts by person. attempts: in total; one each if nothing was retried."""

    people: int
    jobs: int
    seconds: float
    peaks: Peaks
    judged: dict[str, Judged]
    attempts: int
    lags: list[float]

    @property
    def rate(self) -> float:
        return self.people / self.seconds * 60


def main() -> None:
    raw = argparse.RawDescriptionHelpFormatter
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=raw)
    parser.add_argument("--exercise", default="18-publisher")
    parser.add_argument("--people", type=int, default=100)
    parser.add_argument("--sizes", type=numbers, help="class sizes to grade, separated by commas")
    parser.add_argument("--jobs", type=numbers, default=[default_jobs()], help="gradings at once")
    parser.add_argument("--sample", type=int, default=10, help="how many are checked one by one, too")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="ros2course-bench-") as name:
        folder = Path(name)
        sizes = options.sizes or [options.people]
        everybody = lay_mixed(folder / "class", max(sizes), options.exercise)
        caches = {who: warmed(folder, who, options.exercise) for who in ("grade", "check")}
        half = options.sample // 2
        alone = checked(everybody[:half], options.exercise, caches["check"])
        goes = [
            grade(folder, everybody[:size], options.exercise, jobs, caches["grade"])
            for size in sizes
            for jobs in options.jobs
        ]
        alone += checked(everybody[half : options.sample], options.exercise, caches["check"])
    report(goes, alone)


def numbers(text: str) -> list[int]:
    return [int(part) for part in text.split(",")]


def warmed(folder: Path, who: str, exercise_id: str) -> dict[str, str]:
    """An environment with its own cache, in which the solution is already built."""
    environment = {**os.environ, "ROS2COURSE_CACHE": str(folder / f"cache-{who}"), "PYTHONPATH": str(ROOT)}
    first = lay_mixed(folder / f"first-{who}", 1, exercise_id)
    grade(folder, first, exercise_id, 1, environment)
    return environment


def command(*words: object) -> list[str]:
    return [sys.executable, "-m", "course", *map(str, words)]


def grade(folder: Path, homes: Sequence[Path], exercise: str, jobs: int, environment: dict[str, str]) -> Go:
    people, out = folder / "some", folder / "out"
    for left in (people, out):
        shutil.rmtree(left, ignore_errors=True)
    people.mkdir()
    for home in homes:
        (people / home.name).symlink_to(home)
    words = command("grade", people, "--exercises", exercise, "--jobs", jobs, "--out", out)
    began = time.monotonic()
    nowhere = subprocess.DEVNULL
    with (
        subprocess.Popen(words, env=environment, stdout=nowhere, stderr=nowhere) as one,
        watched(one.pid) as peaks,
    ):
        one.wait()
    seconds = time.monotonic() - began
    with Results.open(out, create=False) as results:
        stored = [each for one in results.submissions() for each in results.gradings(one.person)]
    judged = {each.unit.person: judgment(each.result) for each in stored}
    attempts = sum(each.unit.attempt for each in stored)
    return Go(len(homes), jobs, seconds, peaks, judged, attempts, [each.result.timing.lag for each in stored])


@contextlib.contextmanager
def watched(pid: int) -> Iterator[Peaks]:
    peaks, over, top = Peaks(), threading.Event(), psutil.Process(pid)

    def look() -> None:
        while not over.wait(LOOK_EVERY):
            with contextlib.suppress(psutil.Error):
                peaks.look(top)

    thread = threading.Thread(target=look)
    thread.start()
    try:
        yield peaks
    finally:
        over.set()
        thread.join()


def _role(process: psutil.Process) -> str:
    words = process.cmdline()
    if words and words[0].endswith("bwrap"):
        return "bubblewrap"
    role = next((role for module, role in ROLES if module in words), "submission, build")
    parent = process.parent() if role == "recording" else None
    if parent is not None and RECORDING not in parent.cmdline():
        return "fork server"
    return role


def checked(
    homes: Sequence[Path], exercise: str, environment: dict[str, str]
) -> list[tuple[str, float, Judged]]:
    """Check each with a separate command, as an instructor would. Return person, seconds, verdict."""
    found = []
    for home in homes:
        subprocess.run(command("init", home), env=environment, check=True, stdout=subprocess.DEVNULL)
        words = command("--home", home, "check", exercise, "--json")
        began = time.monotonic()
        done = subprocess.run(words, env=environment, check=False, capture_output=True, text=True)
        result = from_json(json.dumps(json.loads(done.stdout)))
        found.append((home.name, time.monotonic() - began, judgment(result)))
        shutil.rmtree(home / ".ros2course")
    return found


def judgment(result: Result) -> Judged:
    failed = frozenset(check.id for check in result.checks if check.outcome is Outcome.FAILED)
    return result.verdict.value, failed


def report(goes: Sequence[Go], alone: Sequence[tuple[str, float, Judged]]) -> None:
    one_by_one = 60 * len(alone) / sum(seconds for _, seconds, _ in alone) if alone else 0.0
    rows = [row(go, one_by_one) for go in goes]
    head = ("people", "jobs", "whole (s)", "a minute", "x check", "s each", "attempts", "our error", "lag")
    show("grade", head, rows)
    roles = (
        "coordinator",
        "worker",
        "fork server",
        "recording",
        "judging",
        "submission, build",
        "bubblewrap",
    )
    sizes = [[str(go.people), str(go.jobs)] for go in goes]
    memory = [[f"{go.peaks.memory[role] / MB:.0f}" for role in roles] for go in goes]
    used = [[f"{go.peaks.seconds(role) / go.people:.2f}" for role in roles] for go in goes]
    for title, figures in (
        ("Peak memory of one process (MB)", memory),
        ("CPU time for each submission (s)", used),
    ):
        table = [size + more for size, more in zip(sizes, figures, strict=True)]
        show(title, ("people", "jobs", *roles), table)
    if alone:
        same = sum(goes[-1].judged[person] == judged for person, _, judged in alone)
        print(f"\ncheck, one after another: {one_by_one:.1f} a minute")
        print(f"verdicts and failed checks that are the same: {same} of {len(alone)}")
        for person, _, judged in alone:
            if goes[-1].judged[person] != judged:
                print(f"  {person}: {judged} by check, {goes[-1].judged[person]} by grade")


def row(go: Go, one_by_one: float) -> list[str]:
    ours = sum(verdict == "our error" for verdict, _ in go.judged.values())
    ratio = f"{go.rate / one_by_one:.1f}" if one_by_one else ""
    figures = (f"{go.seconds:.1f}", f"{go.rate:.1f}", ratio, f"{go.seconds / go.people:.2f}")
    return [str(go.people), str(go.jobs), *figures, str(go.attempts), str(ours), f"{max(go.lags):.2f}"]


if __name__ == "__main__":
    main()
