"""A driver, and who watches or commands it, in a network of their own."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from course.isolation.levels import isolated
from course.rosenv import find_ros, node_environment
from tests.underlay.sas.built import environment, program

HERE = Path(__file__).parent
PARAMETERS: dict[str, Any] = {
    "ip": "127.0.0.1",
    "joint_limits_min": [-360.0, -360.0, -360.0, -360.0, -360.0, -720.0],
    "joint_limits_max": [360.0, 360.0, 360.0, 360.0, 360.0, 720.0],
    "thread_sampling_time_sec": 0.002,
}
_TIMEOUT = 240.0


def driver(**parameters: Any) -> list[str]:
    """Its command line with the tutorial's parameters; None leaves one out."""
    words = [program("driver_node"), "--ros-args", "-r", "__node:=myrobot_1"]
    for name, value in {**PARAMETERS, **parameters}.items():
        if value is not None:
            words += ["-p", f"{name}:={json.dumps(value)}"]
    return words


def watched(command: Sequence[str], *steps: Sequence[Any]) -> dict[str, Any]:
    """What the witness reports of the driver after these steps and its end."""
    job = {"driver": list(command), "steps": [*steps, ["end"]]}
    return dict(json.loads(_run([_python(), str(HERE / "witness.py")], environment(), json.dumps(job))))


def ended(command: Sequence[str]) -> dict[str, Any]:
    """What a driver says that ends by itself, with nobody to hear it."""
    done = _done(command, environment())
    return {"stdout": done.stdout, "stderr": done.stderr, "code": done.returncode}


def beside(command: Sequence[str], *others: str) -> str:
    """What a program prints that is run while the driver runs."""
    return _run([_python(), str(HERE / "beside.py"), json.dumps(list(command)), *others], environment())


def alone(*command: str) -> str:
    """What a program in Python prints that needs no driver."""
    return _run(command, node_environment(find_ros()))


def _run(command: Sequence[str], variables: Mapping[str, str], text: str = "") -> str:
    done = _done(command, variables, text)
    assert done.returncode == 0, done.stderr
    return done.stdout


def _done(
    command: Sequence[str], variables: Mapping[str, str], text: str = ""
) -> subprocess.CompletedProcess[str]:
    with isolated() as around:
        return subprocess.run(
            [*around.prefix, *command], env={**variables, **around.environment}, input=text,
            capture_output=True, text=True, timeout=_TIMEOUT, check=False,
        )  # fmt: skip


def python(name: str) -> tuple[str, str]:
    """The command for a program of ours that is beside this file."""
    return _python(), str(HERE / name)


def _python() -> str:
    return str(find_ros().python)
