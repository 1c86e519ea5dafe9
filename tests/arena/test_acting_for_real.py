"""Parameters, names and launch files, with real ROS."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import pytest

from course.isolation.levels import isolated
from course.rosenv import find_ros, node_environment, prepare

pytestmark = pytest.mark.slow

ACT = Path(__file__).with_name("act.py")
REPO = str(Path(__file__).parents[2])
TIMEOUT = 150.0


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    folder = tmp_path_factory.mktemp("act")
    ros = find_ros()
    prepare(ros)
    environment = node_environment(ros)
    environment["PYTHONPATH"] = ":".join(filter(None, [REPO, environment.get("PYTHONPATH")]))
    with isolated(namespaces=False) as around:
        done = subprocess.run(
            [str(ros.python), str(ACT), str(folder)],
            env=environment | around.environment,
            capture_output=True,
            text=True,
            timeout=TIMEOUT,
            check=False,
        )
    assert done.returncode == 0, done.stderr
    return dict(json.loads(done.stdout))


def test_parameters_reach_the_node_as_they_are(found: dict[str, Any]) -> None:
    assert found["available"]
    assert found["answered"]
    assert found["parameters"] == {
        "plain": ["string", "hello"],
        "number": ["string", "0.5"],
        "truth": ["string", "true"],
        "empty": ["string", ""],
        "hard": ["string", 'say "hi": {häufig} #1'],
        "speed": ["double", 0.25],
        "whole": ["double", 2.0],
        "count": ["integer", 3],
        "on": ["bool", True],
        "sizes": ["double array", [1.0, 2.0]],
        "names": ["string array", ["a", "1"]],
    }


def test_a_launch_file_starts_its_nodes(found: dict[str, Any]) -> None:
    assert found["launched"], found["all"]
    assert found["quote"] == ["string", "7 up"]
    assert sorted(found["processes"]) == ["talker-1", "talker-2"]


def test_one_ctrl_c_ends_them_all(found: dict[str, Any]) -> None:
    code, error, left = found["main"]
    assert (error, left) == (None, 0), found["all"]
    assert code is not None
    assert found["signals"] == [2]
    assert all(found["processes"].values()), found["all"]


def test_who_printed_a_traceback_is_known(found: dict[str, Any]) -> None:
    assert list(found["tracebacks"].values()) == ["KeyboardInterrupt"]


def test_what_launch_complains_of_is_there_to_read(found: dict[str, Any]) -> None:
    assert any("generate_launch_description" in line for line in found["broken"])
    assert any("no_launch.py" in line for line in found["missing"])
