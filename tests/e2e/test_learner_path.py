"""A learner's way, on a pseudo-terminal: next, check (failing), hint, edit, check (passing), next."""

from __future__ import annotations

import re
from pathlib import Path

import pexpect
import pytest

from .conftest import COMMAND, Type, lay

pytestmark = pytest.mark.slow

NODE = "12-print-forever"


def test_from_the_first_command_to_a_node_that_passes(terminal: Type, course_home: Path) -> None:
    first = terminal("next")
    assert str(course_home) in first.replace("\r\n", "")
    assert "01-files" in first
    assert NODE in terminal("next", NODE)
    starter = course_home / "ros2_tutorial_workspace/src/python_package_with_a_node/setup.py"
    assert starter.exists()

    failing = terminal("check", code=1)
    assert "No executable found" in failing
    assert "setup.py" in failing
    assert "ros2course hint" in failing

    assert "1 of" in terminal("hint")
    assert "2 of" in terminal("hint")

    lay("12-a-node-from-scratch", course_home)
    passing = terminal("check")
    assert "Passed: 9 of 9 points" in passing
    assert "ros2course next" in passing

    assert "Chapter 13" in terminal("next")
    listing = terminal("list")
    assert re.search(rf"ok +{NODE}", listing)
    assert "18-publisher" in listing


def test_next_leaves_the_learners_files_alone(terminal: Type, course_home: Path) -> None:
    terminal("next", NODE)
    mine = course_home / "ros2_tutorial_workspace/src/python_package_with_a_node/setup.py"
    mine.write_text("# mine\n", encoding="utf-8")
    terminal("next", NODE)
    assert mine.read_text(encoding="utf-8") == "# mine\n"


def test_ctrl_c_during_a_check(environment: dict[str, str], guarded_home: Path, terminal: Type) -> None:
    home = guarded_home / "ros2course"
    terminal("next", NODE)
    lay("12-a-node-from-scratch", home)
    terminal("check")  # builds
    child = pexpect.spawn(
        COMMAND[0],
        [*COMMAND[1:], "check"],
        env=environment,
        cwd=str(guarded_home),
        encoding="utf-8",
        timeout=60,
    )
    child.expect("watching")
    child.sendintr()
    shown = child.read()
    child.close()
    assert child.exitstatus == 130, shown
    assert "does not count" in shown
    assert list((guarded_home / "scratch").iterdir()) == []
    assert "tried" not in terminal("list") or "9" in terminal("list")
