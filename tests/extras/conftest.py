"""The optional tools are tested like the core: on its small courses, with its commands."""

from __future__ import annotations

from tests.batch.conftest import lay, quiz_course
from tests.cli.conftest import ros2course

__all__ = ["lay", "quiz_course", "ros2course"]
