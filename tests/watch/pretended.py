"""Replaces course.watch.check_worker: a check that says what the learner's light.py tells it to.

Each check that begins and each that was called off leaves a line in `calls`, beside the course home.
"""

from __future__ import annotations

import os
import sys
import threading
from pathlib import Path

from course.errors import MissingHere
from course.grading import check
from course.grading.check import Request
from course.grading.supervisor import ForkServer
from course.model.feedback import Feedback
from course.model.result import CheckResult, Outcome, Result, Verdict
from course.watch import check_worker

LIGHT = "ros2_tutorial_workspace/src/lanterns/lanterns/light.py"
FLOOD = 100


def check_exercise(request: Request, fork_server: ForkServer) -> Result:
    home = request.home
    told = (home / LIGHT).read_text().strip() if (home / LIGHT).is_file() else "dark"
    try:  # whatever tells a test that it has begun is within
        note(home, f"began {told}")
        if told.startswith("waits"):
            request.on_progress(f"looking at the {told} lantern")
            threading.Event().wait(300)
    finally:
        if told.startswith("waits"):
            note(home, f"ended {told}")
    if told == "lacks":
        raise MissingHere("There is no lamp oil on this machine.", "Buy some.")
    if told == "breaks":
        raise RuntimeError("the wick")
    if told.startswith("seeks"):
        request.so_far(Result(request.exercise.id, *judged("half")))
        told = "falls" if told == "seeks and falls" else "dark"
    if told == "falls":
        print("out of oil", file=sys.stderr, flush=True)
        os._exit(7)
    return Result(request.exercise.id, *judged(told))


def judged(told: str) -> tuple[Verdict, tuple[CheckResult, ...]]:
    if told == "flood":
        details = tuple(f"\x1b[31mline {n} " + "x" * 500 for n in range(FLOOD))
        return Verdict.NOT_PASSED, tuple(failed(f"f{n}", f"Flood {n}", details) for n in range(200))
    stands, shines = told in ("half", "bright"), told == "bright"
    checks = (one("stands", "It stands", stands), one("shines", "It shines", shines))
    return Verdict.PASSED if shines else Verdict.NOT_PASSED, checks


def one(name: str, title: str, passes: bool) -> CheckResult:
    return CheckResult(name, title, 2, Outcome.PASSED) if passes else failed(name, title)


def failed(name: str, title: str, details: tuple[str, ...] = ()) -> CheckResult:
    feedback = Feedback("It is dark.", advice="Light it.", details=details)
    return CheckResult(name, title, 2, Outcome.FAILED, feedback=feedback)


def note(home: Path, text: str) -> None:
    with (home.parent / "calls").open("a") as calls:
        calls.write(f"{text}\n")


if __name__ == "__main__":
    check.check_exercise = check_exercise
    check_worker.ForkServer.start_early = lambda self: None  # type: ignore[method-assign]
    check_worker.find_ros = lambda: None  # type: ignore[assignment, return-value]
    raise SystemExit(check_worker.main())
