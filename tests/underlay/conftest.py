"""The underlay is tested as a learner has it: in the environment of the course, made ready once."""

from __future__ import annotations

import pytest

from course.rosenv import find_ros, prepare


@pytest.fixture(scope="session", autouse=True)
def _ros_is_ready() -> None:
    prepare(find_ros())
