"""How much longer `check 18-publisher` takes than the five messages that it watches, and than `launch_test`.

The whole command is timed, as a learner runs it, with nothing to rebuild. With --launch-testing, the same
checks, written by hand (bench/launch_peer.py), are timed in turns with it. No package index has
launch_testing: name its folder in a checkout of https://github.com/ros2/launch, branch jazzy.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

from solved import solved
from table import show, spread

from course.build import Store, Workspace, build
from course.content.layout import WORKSPACE
from course.rosenv import find_ros, node_environment, prepare

ROOT = Path(__file__).parents[1]
EXERCISE = "18-publisher"
PACKAGES = ("package_with_interfaces", "python_package_that_uses_the_messages")
FLOOR = 5 * 0.5


def main() -> None:
    raw = argparse.RawDescriptionHelpFormatter
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=raw)
    parser.add_argument("--rounds", type=int, default=10)
    parser.add_argument("--launch-testing", type=Path, help="the folder launch_testing of a checkout")
    options = parser.parse_args()
    with solved(EXERCISE) as (_, home), contextlib.ExitStack() as keep:
        init = [sys.executable, "-m", "course", "init", str(home)]
        subprocess.run(init, cwd=ROOT, check=True, capture_output=True)
        once(home)  # builds
        peer = peer_environment(home, options.launch_testing, keep) if options.launch_testing else None
        taken, peers = [], []
        for _ in range(options.rounds):
            taken.append(once(home))
            if peer:
                peers.append(peer_once(peer))
    total = [wall for wall, _ in taken]
    evidence = [result["timing"]["evidence"] for _, result in taken]
    rows = [
        ["five messages at 2 Hz (floor)", *[f"{FLOOR:.3f}"] * 3, "0.000"],
        ["evidence, with the node's start and end", *spread(evidence), f"{median(evidence) - FLOOR:.3f}"],
        [f"check {EXERCISE}", *spread(total), f"{median(total) - FLOOR:.3f}"],
    ]
    if peers:
        rows.append(["launch_test", *spread(peers), f"{median(peers) - FLOOR:.3f}"])
    passed = sum(result["verdict"] == "passed" for _, result in taken)
    head = ("what", "median", "90 %", "slowest", "more than floor")
    show(f"A check with nothing to rebuild, {passed} of {options.rounds} passed (s)", head, rows)
    if peers:
        print(f"\ncheck / launch_test: {median(total) / median(peers):.2f}")


def once(home: Path) -> tuple[float, dict]:
    environment = {**os.environ, "_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1"}
    command = [sys.executable, "-m", "course", "--home", str(home), "check", EXERCISE, "--json"]
    began = time.monotonic()
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, check=False)
    return time.monotonic() - began, json.loads(done.stdout)


def peer_environment(home: Path, launch_testing: Path, keep: contextlib.ExitStack) -> dict[str, str]:
    """The environment of `launch_test`: packages that are built as `check` does, and its own ROS domain."""
    prepare(ros := find_ros())
    built = build(Workspace.scan(home / WORKSPACE), PACKAGES, ros, Store(), keep=keep)
    found = node_environment(ros, built.prefixes)
    logs = keep.enter_context(tempfile.TemporaryDirectory(prefix="ros2course-bench-"))
    path = f"{launch_testing.resolve()}:{found['PYTHONPATH']}"
    return {**found, "PYTHONPATH": path, "ROS_LOG_DIR": logs, "ROS_DOMAIN_ID": "93"}


def peer_once(environment: dict[str, str]) -> float:
    """Run it once, and return the seconds. Raises CalledProcessError if it does not pass."""
    command = [sys.executable, "-m", "launch_testing.launch_test", str(ROOT / "bench/launch_peer.py")]
    began = time.monotonic()
    subprocess.run(command, env=environment, check=True, capture_output=True)
    return time.monotonic() - began


if __name__ == "__main__":
    main()
