"""How much longer it takes from a save to the verdict on the screen than the check itself takes.

`watch` runs on a pseudo-terminal. A round writes the learner's file and waits for the verdict. The check's
own time is the one that it prints, as `check` does.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from statistics import median

import pexpect
from solved import solved
from table import show, spread

from course.progress import Progress

ROOT = Path(__file__).parents[1]
ALLOWED = 0.3
PATIENCE = 300
KEYS = b"q quit"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--exercise", default="18-publisher")
    parser.add_argument("--rounds", type=int, default=10)
    options = parser.parse_args()
    with solved(options.exercise) as (exercise, home), watching(home, options.exercise) as child:
        file = max(
            (home / name for name in exercise.files if name.endswith(".py")),
            key=lambda one: one.stat().st_size,
        )
        once(child, home, options.exercise, file, 0)  # builds what the round after it needs
        taken = [once(child, home, options.exercise, file, turn + 1) for turn in range(options.rounds)]
    whole, own = [wall for wall, _ in taken], [check for _, check in taken]
    more = [wall - check for wall, check in taken]
    rows = [
        ["the check itself", *spread(own), ""],
        ["from save to verdict", *spread(whole), f"{median(whole) / median(own):.3f}"],
        [f"more than the check (allowed: {ALLOWED})", *spread(more), ""],
    ]
    head = ("what", "median", "90 %", "slowest", "x the check")
    show(f"`watch` of {options.exercise}, {options.rounds} saves (s)", head, rows)


@contextlib.contextmanager
def watching(home: Path, exercise: str) -> Iterator[pexpect.spawn]:
    environment = {**os.environ, "_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1", "TERM": "xterm-256color"}
    command = [sys.executable, "-m", "course", "--home", str(home)]
    subprocess.run([*command[:3], "init", str(home)], cwd=ROOT, check=True, capture_output=True)
    child = pexpect.spawn(
        command[0],
        [*command[1:], "watch", exercise],
        cwd=str(ROOT),
        env=environment,
        timeout=PATIENCE,
        dimensions=(24, 80),
    )
    child.expect_exact(KEYS)
    try:
        yield child
    finally:
        child.send("q")
        child.expect(pexpect.EOF)
        child.close()


def once(child: pexpect.spawn, home: Path, exercise: str, file: Path, turn: int) -> tuple[float, float]:
    """Seconds from the save to the verdict, and of the check. A new comment each time forces a build."""
    child.send("t")  # the last verdict disappears from the screen
    child.expect_exact(f"== {exercise}: ".encode())
    text = file.read_text(encoding="utf-8").partition("\n# turn ")[0]
    began = time.monotonic()
    file.write_text(f"{text}\n# turn {turn}\n", encoding="utf-8")
    child.expect_exact(b"[built in ")
    whole = time.monotonic() - began
    child.expect_exact(KEYS)
    with Progress.open(home / ".ros2course") as progress:
        result = progress.last_result(exercise)
    assert result is not None
    return whole, result.timing.total


if __name__ == "__main__":
    main()
