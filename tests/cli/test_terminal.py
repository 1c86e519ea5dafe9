"""On a real pseudo-terminal: the moving line, Ctrl+C, questions, the shell."""

from __future__ import annotations

import os
import sys
import termios
from collections.abc import Callable, Iterator
from pathlib import Path

import pexpect
import pytest

from course.home import create_home

REPO = Path(__file__).parents[2]
LIGHT = "ros2_tutorial_workspace/src/lanterns/lanterns/light.py"
HIDDEN, SHOWN = "\x1b[?25l", "\x1b[?25h"

# The program with a check that waits for as long as the test wants, and a ROS that only sets a variable.
PROGRAM = """
import os, threading
from pathlib import Path
import course.grading.check
import course.rosenv
from course.model.result import CheckResult, Outcome, Result, Verdict

def check_exercise(request, fork_server):
    try:
        request.on_progress("building lanterns")
        if os.environ["CHECK"] == "waits":
            threading.Event().wait(60)
    finally:
        Path(request.home, "cleaned-up").touch()
    return Result(request.exercise.id, Verdict.PASSED, (CheckResult("a", "It shines", 1, Outcome.PASSED),))

course.grading.check.check_exercise = check_exercise
course.grading.supervisor.ForkServer.start_early = lambda self: None
course.rosenv.find_ros = lambda: None
course.rosenv.prepare = lambda ros: None
course.rosenv.setup_script = lambda ros: Path(os.environ["SETUP"])
from course.cli.main import run
run()
"""
Start = Callable[..., "pexpect.spawn[str]"]


@pytest.fixture
def start(small_course: Path, tmp_path: Path, guarded_home: Path) -> Iterator[Start]:
    """`start("check")` runs a command on a terminal of 80 columns, in a course home of its own."""
    create_home(tmp_path / "home")
    (tmp_path / "setup.bash").write_text("export ROS_DISTRO=pretended\n")
    running: list[pexpect.spawn[str]] = []

    def run(*words: str, check: str = "ends") -> pexpect.spawn[str]:
        kept = {name: value for name, value in os.environ.items() if name not in ("NO_COLOR", "PS1")}
        environment = {
            **kept,
            "PYTHONPATH": str(REPO),
            "ROS2COURSE_HOME": str(tmp_path / "home"),
            "TERM": "xterm",
            "CHECK": check,
            "SETUP": str(tmp_path / "setup.bash"),
        }
        child = pexpect.spawn(
            sys.executable,
            ["-c", PROGRAM, "--course", str(small_course), *words],
            env=environment,
            cwd=str(tmp_path),
            encoding="utf-8",
            timeout=60,
            dimensions=(24, 80),
        )
        running.append(child)
        return child

    yield run
    for child in running:
        child.close(force=True)


def ended(child: pexpect.spawn[str]) -> int | None:
    if not child.flag_eof:
        child.expect(pexpect.EOF)
    child.close()
    status: int | None = child.exitstatus
    return status


def interrupt(child: pexpect.spawn[str]) -> None:
    """Ctrl+C until it ends: one just before Python reads is noticed only at the next key."""
    for _ in range(10):
        child.sendintr()
        if child.expect([pexpect.EOF, pexpect.TIMEOUT], timeout=3) == 0:
            return


@pytest.mark.slow
def test_a_check_moves_one_line_and_leaves_the_result(start: Start) -> None:
    start("next").expect(pexpect.EOF)
    child = start("check")
    child.expect_exact(HIDDEN)
    child.expect_exact("building lanterns")
    child.expect_exact(SHOWN)
    child.expect("ok.*It shines")
    child.expect("Type next:")
    assert ended(child) == 0


@pytest.mark.slow
def test_ctrl_c_stops_a_check_cleanly(start: Start, tmp_path: Path) -> None:
    start("next").expect(pexpect.EOF)
    child = start("check", check="waits")
    before = termios.tcgetattr(child.child_fd)
    child.expect_exact("building lanterns")
    child.sendintr()
    child.expect_exact(SHOWN)
    child.expect_exact("Stopped. This attempt does not count.")
    after = termios.tcgetattr(child.child_fd)
    assert ended(child) == 130
    assert before == after, "the terminal is as it was"
    assert (tmp_path / "home/cleaned-up").exists()


@pytest.mark.slow
def test_kill_stops_a_check_cleanly(start: Start, tmp_path: Path) -> None:
    start("next").expect(pexpect.EOF)
    child = start("check", check="waits")
    child.expect_exact("building lanterns")
    child.kill(15)
    child.expect_exact(SHOWN)
    assert ended(child) == 128 + 15
    assert (tmp_path / "home/cleaned-up").exists()


@pytest.mark.slow
@pytest.mark.parametrize(("answer", "content"), [("n", "mine"), ("", "mine"), ("y", None)])
def test_reset_asks_first(start: Start, tmp_path: Path, answer: str, content: str | None) -> None:
    start("next").expect(pexpect.EOF)
    file = tmp_path / "home" / LIGHT
    first = file.read_text()
    file.write_text("mine")
    child = start("reset", "04-light")
    child.expect_exact("Continue?")
    child.sendline(answer)
    assert ended(child) == 0
    assert file.read_text() == (content or first)


@pytest.mark.slow
def test_reset_can_be_left_with_ctrl_c(start: Start, tmp_path: Path) -> None:
    start("next").expect(pexpect.EOF)
    (tmp_path / "home" / LIGHT).write_text("mine")
    child = start("reset", "04-light")
    child.expect_exact("Continue?")
    interrupt(child)
    assert ended(child) == 130
    assert (tmp_path / "home" / LIGHT).read_text() == "mine"


@pytest.mark.slow
def test_a_shell_in_the_course_home_with_ros_ready(start: Start, tmp_path: Path) -> None:
    home = tmp_path / "home"
    (home / ".bashrc").write_text("export FROM_BASHRC=yes\n")
    child = start("shell")
    child.expect_exact("(ros2course) ~")
    child.sendline('echo "<$HOME> <$PWD> <$ROS_DISTRO> <$FROM_BASHRC> <$ROS2COURSE_HOME>"')
    child.expect_exact(f"<{home}> <{home}> <pretended> <yes> <{home}>")
    child.sendline("ros2course --version")
    child.expect("ros2course [0-9]")
    child.sendline("exit 7")
    assert ended(child) == 7


def test_the_shell_s_cache_is_the_one_outside(
    start: Start, guarded_home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("ROS2COURSE_CACHE")
    monkeypatch.delenv("XDG_CACHE_HOME")
    child = start("shell", "-c", 'echo "<$ROS2COURSE_CACHE>"; exit 3')
    child.expect_exact(f"<{guarded_home}/.cache/ros2course>")
    assert ended(child) == 3


@pytest.mark.slow
def test_ids_complete_in_the_shell(start: Start, small_course: Path) -> None:
    child = start("shell")
    child.expect_exact("(ros2course) ~")
    child.send("ros2course solu\t")
    child.expect_exact("solution")
    child.sendcontrol("u")
    child.sendline("exit")
    child.expect(pexpect.EOF)


@pytest.mark.slow
def test_colour_only_where_it_is_wanted(start: Start, monkeypatch: pytest.MonkeyPatch) -> None:
    child = start("next")
    child.expect(pexpect.EOF)
    assert "\x1b[" in child.before
    monkeypatch.setenv("NO_COLOR", "1")
    (plain := start("list")).expect(pexpect.EOF)
    assert "04-light" in plain.before


@pytest.mark.slow
def test_a_pager_shows_a_long_text(start: Start, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PAGER", "cat")
    child = start("next", "--pager")
    child.expect_exact("brightness")
    assert ended(child) == 0
