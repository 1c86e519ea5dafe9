"""Case by case: the same words, in the same order, with the same exit code as the real command."""

from __future__ import annotations

import shutil
import signal
from pathlib import Path

import pexpect
import pytest

from tests.underlay.launch.captured import CAPTURES, Capture, capture, normal
from tests.underlay.launch.machine import Answer, Launcher, gone, there

AT_ONCE = (
    "bad_arg_syntax",
    "bad_package",
    "missing_required_arg",
    "no_file_arg",
    "print",
    "print_with_args",
    "show_args",
    "show_args_with_args",
    "syntax_error",
    "unknown_file",
)
INTERRUPTED = ("path", "pkg_file", "with_args")


def _words(launcher: Launcher, case: Capture) -> list[str]:
    _write_files(launcher)
    places = {"<cwd>": str(launcher.cwd), "<workspace>": str(launcher.workspace)}
    words = list(case.words)
    for placeholder, path in places.items():
        words = [word.replace(placeholder, path) for word in words]
    return words


def _write_files(launcher: Launcher) -> None:
    """The launch files of the captures; the one with a syntax error no linter would let pass as a file."""
    shutil.copytree(CAPTURES / "files", launcher.cwd / "files")
    launcher.file("def generate_launch_description(:\n    pass\n", "files/syntax_error_launch.py")


def _paths(launcher: Launcher) -> dict[str, str]:
    return {str(launcher.home): "<home>", str(launcher.workspace): "<workspace>"}


def _same(launcher: Launcher, case: Capture, answer: Answer) -> None:
    assert normal(answer.stdout, _paths(launcher)) == normal(case.stdout)
    assert normal(answer.stderr, _paths(launcher)) == normal(case.stderr)
    assert answer.code == case.code


@pytest.mark.parametrize("name", AT_ONCE)
def test_answers_at_once(launcher: Launcher, name: str) -> None:
    case = capture(name)
    _same(launcher, case, launcher(*_words(launcher, case)))


@pytest.mark.parametrize("name", INTERRUPTED)
def test_interrupted(launcher: Launcher, name: str) -> None:
    case = capture(name)
    with launcher.started(*_words(launcher, case)) as running:
        running.wait_for("process started")
        running.signal(signal.SIGINT)
        _same(launcher, case, running.finish())


@pytest.mark.slow
def test_two_nodes(launcher: Launcher) -> None:
    case = capture("two_nodes")
    with launcher.started(*_words(launcher, case)) as running:
        running.wait_for_all("Printed 2 times", "[sample_python_node-2]: process has finished cleanly")
        running.signal(signal.SIGINT)
        answer = running.finish()
    # What two processes write has no order among them.
    ours, theirs = normal(answer.stdout, _paths(launcher)), normal(case.stdout)
    assert sorted(set(ours)) == sorted(set(theirs))
    assert ours[:3] == theirs[:3] and ours[-3:] == theirs[-3:]
    assert answer.code == case.code


@pytest.mark.slow
def test_on_a_terminal_ctrl_c_ends_children_well(launcher: Launcher) -> None:
    case = capture("pkg_file_tty")
    line = launcher.line(*_words(launcher, case))
    ready = launcher.cwd / "ready"
    environment = {**launcher.environment, "ENDS_WELL": str(ready)}
    child = pexpect.spawn(
        line[0], line[1:], env=environment, cwd=str(launcher.cwd), encoding="utf-8", echo=False
    )
    child.expect_exact("process started with pid [")
    told = child.before + child.after
    there(ready)
    child.sendintr()
    child.expect(pexpect.EOF)
    child.close()
    assert normal(told + child.before, _paths(launcher)) == normal(case.stdout)
    assert child.exitstatus == case.code


def test_sigterm_ends_the_nodes_first(launcher: Launcher) -> None:
    """The real one leaves them behind; its exit code is kept."""
    case = capture("sigterm")
    with launcher.started(*_words(launcher, case)) as running:
        pid = running.pid_of("amazing_quote_configurable_publisher_node-1")
        running.signal(signal.SIGTERM)
        answer = running.finish()
    assert not Path(f"/proc/{pid}").exists()
    ours = normal(answer.stdout, _paths(launcher))
    assert ours[:3] == normal(case.stdout)
    assert ours[3] == "[WARNING] [launch]: told to end (SIGTERM), shutting down"
    assert answer.code == case.code
    assert not list((launcher.cwd.parent / "tmp").iterdir())


def test_sigkill_leaves_nothing_behind(launcher: Launcher) -> None:
    """The real one does."""
    case = capture("sigkill_pid_only")
    with launcher.started(*_words(launcher, case)) as running:
        pid = running.pid_of("amazing_quote_configurable_publisher_node-1")
        running.signal(signal.SIGKILL)
        answer = running.finish()
        assert gone(pid)
    assert normal(answer.stdout, _paths(launcher)) == normal(case.stdout)
    assert answer.code == case.code


def test_every_capture_is_compared() -> None:
    compared = {*AT_ONCE, *INTERRUPTED, "two_nodes", "pkg_file_tty", "sigterm", "sigkill_pid_only"}
    assert {path.stem.removeprefix("launch_") for path in CAPTURES.glob("launch_*.txt")} == compared
