"""The programs of `workspace`, built once for their content and that of the underlay."""

from __future__ import annotations

import subprocess
from functools import cache
from pathlib import Path

from course.build import Store, Workspace, build
from course.build.underlay_build import provide
from course.rosenv import find_ros, node_environment, prepare

_WORKSPACE = Path(__file__).with_name("workspace")
PACKAGE = "sas_probes"


@cache
def probes() -> Path:
    """The install prefix. What is in it stays from one run of the tests to the next."""
    ros = find_ros()
    prepare(ros)
    workspace = Workspace.scan(_WORKSPACE)
    provide(workspace, [PACKAGE], ros)
    outcome = build(workspace, [PACKAGE], ros, Store())
    assert outcome.failure is None, outcome.failure
    return outcome.prefixes[-1]


def program(name: str) -> str:
    return str(probes() / "lib" / PACKAGE / name)


def environment() -> dict[str, str]:
    """For programs that use the underlay, in C++ or in Python."""
    return node_environment(find_ros(), [probes()])


def output_of(*command: str) -> str:
    """For programs that need no other."""
    done = subprocess.run(
        command, env=environment(), capture_output=True, text=True, timeout=60, check=False
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return done.stdout
