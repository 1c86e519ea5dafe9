"""How long commands of our `ros2` take among running nodes, compared with the real ones.

The real command is not available from pip, so its times are from one earlier run on a machine with two cores
and a warm daemon: only large differences mean something. The baselines are from this run.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import time
from collections.abc import Mapping
from pathlib import Path
from statistics import median

from table import show, spread

from course.isolation.levels import isolated
from course.rosenv import find_ros, node_environment, prepare

ROOT = Path(__file__).parents[1]
NODES = (("demo_nodes_py", "talker"), ("demo_nodes_py", "listener"))
# Wall time of the real command in seconds; None if there is nothing to compare.
CAPTURED: Mapping[str, float | None] = {
    "ros2 -h": 0.421,
    "ros2 pkg list": 0.232,
    "ros2 pkg executables demo_nodes_py": 0.268,
    "ros2 interface show std_msgs/msg/String": 0.298,
    "ros2 topic list": 0.371,
    "ros2 topic list --no-daemon": 1.010,
    "ros2 topic info -v /chatter": 0.381,
    "ros2 node list": 0.340,
    "ros2 node list --no-daemon": 0.992,
    "ros2 node info /talker": 0.332,
    "ros2 service list -t": 0.394,
    "ros2 param list /talker": 2.018,
    "ros2 param get /talker use_sim_time": 1.199,
    "ros2 service type /talker/get_parameters": 0.344,
    "ros2 topic type /chatter": 0.384,
    "ros2 launch no_such_package x_launch.py": 0.326,
}
FLOORS = {"python -c pass": ("-c", "pass"), "python -c 'import rclpy'": ("-c", "import rclpy")}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=10)
    parser.add_argument("--inside", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.inside:
        print(json.dumps(measured(options.rounds)))
        return
    times = in_namespaces(options.rounds)
    floor = median(times["python -c pass"])
    rows = [row(name, taken, floor) for name, taken in times.items()]
    head = ("command", "median", "90 %", "slowest", "x floor", "real one", "ours / real")
    show(f"ros2 commands, {options.rounds} rounds (s)", head, rows)


def row(name: str, taken: list[float], floor: float) -> list[str]:
    real = CAPTURED.get(name)
    compared = [f"{real:.3f}", f"{median(taken) / real:.2f}"] if real else ["", ""]
    return [name, *spread(taken), f"{median(taken) / floor:.1f}", *compared]


def in_namespaces(rounds: int) -> dict[str, list[float]]:
    ros = find_ros()
    prepare(ros)
    with isolated() as where:
        environment = {**node_environment(ros), **where.environment}
        environment["PYTHONPATH"] += f":{ROOT}"
        command = [*where.prefix, sys.executable, __file__, "--inside", "--rounds", str(rounds)]
        done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, check=True, text=True)
    return json.loads(done.stdout.splitlines()[-1])


def measured(rounds: int) -> dict[str, list[float]]:
    """Runs inside: every command once in each round, so that a busy moment affects them all."""
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    nodes = [subprocess.Popen(["ros2", "run", *node], **quiet) for node in NODES]
    commands = {name: [sys.executable, *words] for name, words in FLOORS.items()}
    commands |= {name: name.split() for name in CAPTURED}
    try:
        wait_for_nodes()
        times: dict[str, list[float]] = {name: [] for name in commands}
        for _ in range(rounds):
            for name, command in commands.items():
                began = time.monotonic()
                subprocess.run(command, **quiet, check=False)
                times[name].append(time.monotonic() - began)
    finally:
        subprocess.run(["ros2", "daemon", "stop"], **quiet, check=False)
        for node in nodes:
            node.terminate()
            node.wait()
    return times


def wait_for_nodes() -> None:
    """Ask until all are listed. This also warms the daemon, as it was for the real figures."""
    for _ in range(100):
        listed = subprocess.run(["ros2", "node", "list"], capture_output=True, text=True, check=False).stdout
        if len(listed.split()) >= len(NODES):
            return
    raise SystemExit("the nodes did not start")


if __name__ == "__main__":
    main()
