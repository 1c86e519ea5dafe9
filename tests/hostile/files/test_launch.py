"""A launch file is a program, and trusted no more than any other."""

from __future__ import annotations

import pytest

from course.content import open_course
from course.model.result import Verdict
from tests.hostile.builds.conftest import attack
from tests.hostile.files.conftest import GradeHome
from tests.hostile.world import NODE, SECRET, SRC

pytestmark = pytest.mark.slow
EXERCISE = "22-launch"
LAUNCHES = "python_package_that_uses_parameters_and_launch_files"
FILE = f"{SRC}/{LAUNCHES}/launch/peanut_butter_falcon_quote_publisher_launch.py"


def solution() -> str:
    return (open_course().exercise(EXERCISE).solution / FILE).read_text(encoding="utf-8")


def test_it_reads_nothing_private(grade_home: GradeHome, course_copy: object) -> None:
    places = [str(course_copy), f"{course_copy}/solutions", "/root", "/etc/shadow", "/proc/1/environ"]
    text = attack("reads", PLACES=places, SECRET=SECRET) + solution()
    graded = grade_home({FILE: text}, EXERCISE, guarantee="launch files see only what they need")
    assert graded.held, [graded.words(name) for name in graded.failed]
    # Launch makes pipes of its own, and the shell around it is another of its processes.
    serious = [
        line for line in graded.breaches if "own descriptors" not in line and "environments" not in line
    ]
    assert not [line for line in serious if " descriptors" not in line]
    assert graded.held >= {*(f"place {number}" for number in range(5)), "search", "passwords"}
    assert graded.result.verdict is Verdict.PASSED, graded.failed


def test_it_starts_a_fork_bomb(grade_home: GradeHome) -> None:
    bomb = "import os\nwhile True:\n    try:\n        os.fork()\n    except OSError:\n        pass\n"
    graded = grade_home(
        {FILE: bomb + solution()}, EXERCISE, guarantee="a launch file cannot fork without end"
    )
    assert graded.result.verdict is Verdict.NOT_PASSED
    assert graded.result.fault is None
    told = [graded.words(name) for name in graded.failed]
    assert any("started more than" in words for words in told), told


def test_a_second_process_that_helps(grade_home: GradeHome) -> None:
    """The node itself is silent; its child, a node with another name, publishes the messages."""
    honest = (open_course().exercise("18-publisher").solution / NODE).read_text(encoding="utf-8")
    text = f"""
import os, subprocess, sys
HELPER = {honest.replace("'amazing_quote_publisher_node'", "'helper'")!r}
if '__helper' not in os.environ:
    subprocess.Popen([sys.executable, '-c', HELPER + '\\nmain()'], env=dict(os.environ, __helper='1'))
import rclpy
from rclpy.node import Node
def main():
    rclpy.init()
    rclpy.spin(Node('amazing_quote_publisher_node'))
"""
    graded = grade_home({NODE: text}, guarantee="what is asked of a node counts only when that node does it")
    assert graded.result.fault is None
    assert graded.result.verdict is Verdict.NOT_PASSED, graded.result
