"""Runs the ros2 command among nodes in a network of their own, and reads what the real one printed."""

from __future__ import annotations

import json
import re
import shlex
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from course.arena.enclosure import enclosure
from course.rosenv import find_ros, node_environment

HERE = Path(__file__).parent
CAPTURES = HERE.parent / "captures"
SOURCES = HERE.parents[2] / "underlay/src"
# The captures were taken with types of the tutorial's own, which are not built for these tests.
_OTHER_TYPES = {
    "package_with_interfaces/msg/AmazingQuote": "std_msgs/msg/Int64",
    "package_with_interfaces/srv/WhatIsThePoint": "std_srvs/srv/SetBool",
}
_VARIES = {
    r"RIHS01_[0-9a-f]{64}": "<hash>",
    r"GID: [0-9a-f.]+": "GID: <gid>",
    r"_ros2cli_(daemon_)?\w+": "_ros2cli_<id>",
}


@dataclass(frozen=True)
class Outcome:
    code: int
    stdout: str
    stderr: str


def environment() -> dict[str, str]:
    variables = node_environment(find_ros())
    packages = [str(SOURCES / name) for name in ("ros2cli", "rosidl_runtime_py")]
    return {
        **variables,
        "PYTHONPATH": ":".join([*packages, variables.get("PYTHONPATH", "")]),
        "COLUMNS": "80",
    }


def ros2(*arguments: str) -> Outcome:
    """For what needs no nodes."""
    command = [str(find_ros().python), "-m", "ros2cli", *arguments]
    done = subprocess.run(command, env=environment(), capture_output=True, text=True, timeout=60, check=False)
    return Outcome(done.returncode, normal(done.stdout), normal(done.stderr))


def ros2_among(nodes: Sequence[str], cases: Sequence[tuple[Sequence[str], float | None]]) -> list[Outcome]:
    """The outcome of each command, run one after the other with the nodes present.

    A case is the arguments, and after how many seconds Ctrl+C is to be pressed.
    """
    job = {"nodes": nodes, "script": str(HERE / "nodes.py"), "cases": cases}
    with enclosure() as around:
        command = [*around.prefix, str(find_ros().python), str(HERE / "driver.py")]
        variables = {**environment(), **around.environment}
        done = subprocess.run(
            command,
            env=variables,
            input=json.dumps(job),
            capture_output=True,
            text=True,
            timeout=300,
            check=False,
        )
    assert done.returncode == 0, done.stderr
    return [
        Outcome(case["code"], normal(case["stdout"]), normal(case["stderr"]))
        for case in json.loads(done.stdout)
    ]


def captured(name: str) -> tuple[list[str], Outcome]:
    """The arguments of the capture, and what came of them when the real command found what was there."""
    text = (CAPTURES / f"{name}.txt").read_text(encoding="utf-8").partition("\n# ==== other outcome")[0]
    head, _, streams = text.partition("# ---- stdout ----\n")
    out, _, err = streams.partition("# ---- stderr ----\n")
    command = re.search(r"^# command: (.*)$", head, re.M)
    code = re.search(r"runs: \[(\d+)", head)
    assert command and code
    return shlex.split(command[1])[1:], Outcome(int(code[1]), normal(out), normal(err))


def normal(text: str) -> str:
    for pattern, instead in {**_OTHER_TYPES, **_VARIES}.items():
        text = re.sub(pattern, instead, text)
    return text
