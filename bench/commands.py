"""Cold time of the quick commands, compared with a Python that starts and does nothing.

Every round runs each command once, so that a busy moment affects them all.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

from table import show, spread

ROOT = Path(__file__).parents[1]
COMMANDS = {
    "python -c pass": [sys.executable, "-c", "pass"],
    "hint": [sys.executable, "-m", "course", "hint", "18-publisher"],
    "list": [sys.executable, "-m", "course", "list"],
    "show": [sys.executable, "-m", "course", "show", "18-publisher"],
    "--help": [sys.executable, "-m", "course", "--help"],
    "./ros2course list": [str(ROOT / "ros2course"), "list"],
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=15)
    rounds = parser.parse_args().rounds
    with tempfile.TemporaryDirectory() as folder:
        environment = {**os.environ, "ROS2COURSE_HOME": folder, "_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1"}
        run([sys.executable, "-m", "course", "init", folder], environment)
        times: dict[str, list[float]] = {name: [] for name in COMMANDS}
        for _ in range(rounds):
            for name, command in COMMANDS.items():
                times[name].append(run(command, environment))
    floor = median(times["python -c pass"])
    rows = [[name, *spread(taken), f"{median(taken) / floor:.1f}"] for name, taken in times.items()]
    show(f"Quick commands, {rounds} rounds (s)", ("command", "median", "90 %", "slowest", "x floor"), rows)


def run(command: list[str], environment: dict[str, str]) -> float:
    began = time.monotonic()
    subprocess.run(command, env=environment, cwd=ROOT, stdout=subprocess.DEVNULL, check=True)
    return time.monotonic() - began


if __name__ == "__main__":
    main()
