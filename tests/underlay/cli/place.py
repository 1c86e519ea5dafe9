"""Runs the ros2 command among nodes in a network of their own."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from course.isolation.levels import isolated
from course.rosenv import find_ros, node_environment
from tests.underlay.cli.captured import Outcome

HERE = Path(__file__).parent
SOURCES = HERE.parents[2] / "underlay/src"
_TIMEOUT = 300.0


def environment(workspace: Path | None = None) -> dict[str, str]:
    """With the packages of the workspace, if there is one."""
    overlays = sorted((workspace / "install").glob("*/")) if workspace else ()
    return {**node_environment(find_ros(), overlays), "COLUMNS": "80"}


def ros2(*arguments: str, workspace: Path | None = None, **variables: str) -> Outcome:
    """For what needs no nodes."""
    command = [str(find_ros().python), "-m", "ros2cli", *arguments]
    done = subprocess.run(
        command, env={**environment(workspace), **variables},
        capture_output=True, text=True, timeout=60, check=False,
    )  # fmt: skip
    return Outcome(done.returncode, done.stdout, done.stderr)


def typed(*words: str, stop: Mapping[str, Any] | None = None) -> dict[str, Any]:
    """A case without a capture: its command line; how it is to be stopped, as `captured.Stop` has it."""
    kinds: dict[str, Any] = {"signal": "SIGINT", "when": None, "after": None, "to_group": True, "lines": 0}
    return {"words": list(words), "stop": {**kinds, **stop} if stop else None, "on_terminal": False}


def among(nodes: Sequence[str], cases: Sequence[Mapping[str, Any]], workspace: Path) -> list[Outcome]:
    """The outcome of each command, run one after the other with the nodes present."""
    python = str(find_ros().python)
    lines = [[python, str(HERE / "nodes.py"), kind] for kind in nodes]
    with isolated() as around:
        done = subprocess.run(
            [*around.prefix, python, str(HERE / "driver.py")],
            env={**environment(workspace), **around.environment},
            input=json.dumps({"nodes": lines, "cases": list(cases)}),
            stdout=subprocess.PIPE, text=True, timeout=_TIMEOUT, check=False,
        )  # fmt: skip
    assert done.returncode == 0, "see stderr"
    return [Outcome(**outcome) for outcome in json.loads(done.stdout)]
