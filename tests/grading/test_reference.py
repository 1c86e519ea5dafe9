"""The environment of a mystery's nodes: the learner's communication settings, and nothing else of theirs."""

from __future__ import annotations

import os
from contextlib import ExitStack
from pathlib import Path

import pytest

from course.build import Store
from course.content import open_course
from course.grading.reference import play_environment
from course.rosenv import find_ros

KEEPERS = open_course(Path(__file__).parents[1] / "fixtures/quiz_course").exercise("05-keepers")


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ({}, {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST", "ROS_DOMAIN_ID": None}),
        ({"ROS_DOMAIN_ID": "7"}, {"ROS_DOMAIN_ID": "7"}),
        ({"ROS_AUTOMATIC_DISCOVERY_RANGE": "SUBNET"}, {"ROS_AUTOMATIC_DISCOVERY_RANGE": "SUBNET"}),
        ({"FASTDDS_BUILTIN_TRANSPORTS": "SHM"}, {"FASTDDS_BUILTIN_TRANSPORTS": "SHM"}),
        ({"MY_SECRET": "x"}, {"MY_SECRET": None}),
    ],
)
def test_what_reaches_the_nodes(
    tmp_path: Path, given: dict[str, str], expected: dict[str, str | None]
) -> None:
    environ = {name: os.environ[name] for name in ("HOME", "PATH")} | given
    with ExitStack() as keep:
        made = play_environment(KEEPERS, find_ros(), keep, store=Store(tmp_path), environ=environ)
    assert {name: made.get(name) for name in expected} == expected
