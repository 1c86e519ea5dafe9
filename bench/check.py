"""How much longer `check 18-publisher` takes than the five messages that it watches.

The whole command is timed, as a learner runs it, with nothing to rebuild.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import time
from pathlib import Path
from statistics import median

from solved import solved
from table import show, spread

ROOT = Path(__file__).parents[1]
EXERCISE = "18-publisher"
FLOOR = 5 * 0.5


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=10)
    rounds = parser.parse_args().rounds
    with solved(EXERCISE) as (_, home):
        init = [sys.executable, "-m", "course", "init", str(home)]
        subprocess.run(init, cwd=ROOT, check=True, capture_output=True)
        once(home)  # builds
        taken = [once(home) for _ in range(rounds)]
    total = [wall for wall, _ in taken]
    evidence = [result["timing"]["evidence"] for _, result in taken]
    rows = [
        ["five messages at 2 Hz (floor)", *[f"{FLOOR:.3f}"] * 3, "0.000"],
        ["evidence, with the node's start and end", *spread(evidence), f"{median(evidence) - FLOOR:.3f}"],
        [f"check {EXERCISE}", *spread(total), f"{median(total) - FLOOR:.3f}"],
    ]
    passed = sum(result["verdict"] == "passed" for _, result in taken)
    head = ("what", "median", "90 %", "slowest", "more than floor")
    show(f"A check with nothing to rebuild, {passed} of {rounds} passed (s)", head, rows)


def once(home: Path) -> tuple[float, dict]:
    environment = {**os.environ, "_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1"}
    command = [sys.executable, "-m", "course", "--home", str(home), "check", EXERCISE, "--json"]
    began = time.monotonic()
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, check=False)
    return time.monotonic() - began, json.loads(done.stdout)


if __name__ == "__main__":
    main()
