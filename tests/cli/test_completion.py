"""The shell completes exercise ids."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

REPO = Path(__file__).parents[2]


def completed(words: str, course: Path) -> list[str]:
    """What bash offers at the end of `words`."""
    line = f"ros2course --course {course} {words}"
    code = "from course.cli.main import run; run()"
    environment = {
        **os.environ,
        "PYTHONPATH": str(REPO),
        "_ROS2COURSE_COMPLETE": "complete_bash",
        "COMP_WORDS": line,
        "COMP_CWORD": str(len(line.split(" ")) - 1),
    }
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, env=environment, check=False
    )
    return done.stdout.split()


@pytest.mark.parametrize("command", ["next", "check", "hint", "show", "reset", "solution"])
def test_ids_complete(small_course: Path, command: str) -> None:
    assert completed(f"{command} 04-l", small_course) == ["04-light"]


def test_commands_complete(small_course: Path) -> None:
    assert completed("so", small_course) == ["solution"]


def test_a_broken_course_only_offers_nothing(small_course: Path) -> None:
    (small_course / "chapters/04-lanterns/lesson.yaml").write_text("chapter: [")
    assert completed("show 04", small_course) == []
