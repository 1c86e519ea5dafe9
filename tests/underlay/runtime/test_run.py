"""`ros2 run`: what it starts, what becomes of signals, and its exit codes."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pexpect
import psutil
import pytest

from course.isolation.levels import isolated
from tests.underlay.runtime.captured import CAPTURES, capture
from tests.underlay.runtime.command import Ros2, ros2_command
from tests.underlay.runtime.conftest import NODES, install, script

CASES = [
    "run_child_crash",
    "run_child_segv",
    "run_missing_arg",
    "run_missing_exe",
    "run_ok_terminates",
    "run_unknown_package",
]

# Counts the signals it gets, and ends half a second after the first: time for a second one to come.
COUNTING = """\
#!/usr/bin/env python3
import signal, sys, time
seen = []
def note(number, frame):
    seen.append(number)
for number in (signal.SIGINT, signal.SIGTERM):
    signal.signal(number, note)
print("ready", flush=True)
while not seen:
    time.sleep(0.01)
end = time.monotonic() + 0.5
while time.monotonic() < end:
    time.sleep(0.01)
print("got", *seen, flush=True)
sys.exit(3)
"""


@pytest.fixture
def tools(tmp_path: Path) -> Ros2:
    """The command with a package of small programs."""
    workspace = tmp_path / "workspace"
    prefix = install(workspace, "tools")
    script(prefix, "counting", COUNTING)
    script(prefix, "tell", '#!/bin/sh\nprintf "[%s]" "$@"\nexit 5\n')
    script(prefix, "sleeping", "#!/bin/sh\necho $$\nexec sleep 60\n")
    return ros2_command(tmp_path, workspace)


@pytest.mark.parametrize("name", CASES)
def test_as_the_real_one(name: str, ros2: Ros2) -> None:
    case = capture(name)
    shutil.copytree(CAPTURES / "files", ros2.cwd / "files")
    answer = ros2(*(word.replace("<cwd>", str(ros2.cwd)) for word in case.arguments))
    assert (answer.code % 256, answer.stdout, answer.stderr) == (case.code, case.stdout, case.stderr)


def test_unknown_executable(ros2: Ros2) -> None:
    answer = ros2("run", NODES, "nosuch")
    assert (answer.code, answer.stdout, answer.stderr) == (1, "", "No executable found\n")


def test_arguments_are_passed_on_as_they_are(tools: Ros2) -> None:
    arguments = ["a b", "--help", "-h", "--prefix", "x", "--ros-args", "-r", "__node:=other", "*", ""]
    answer = tools("run", "tools", "tell", *arguments)
    said, report = answer.stdout.split("[ros2run]")
    assert said == "".join(f"[{argument}]" for argument in arguments)
    assert (answer.code, report) == (5, ": Process exited with failure 5\n")


def test_a_prefix_of_several_words(tools: Ros2) -> None:
    answer = tools("run", "--prefix", "env 'A=b c' sh -c 'echo \"$A\"'", "tools", "tell")
    assert (answer.code, answer.stdout) == (0, "b c\n")


def test_a_prefix_that_is_not_there(tools: Ros2) -> None:
    answer = tools("run", "--prefix", "nosuch_command -x", "tools", "tell")
    assert (answer.code, answer.stderr) == (1, "Cannot run nosuch_command: No such file or directory\n")


@pytest.mark.parametrize("shebang", ["/usr/bin/python0.0", "/nosuch/python3 -u", "/usr/bin/env python0"])
def test_a_script_of_another_python_gets_this_one(shebang: str, tools: Ros2) -> None:
    tell = "import sys; print(sys.executable, *sys.argv[1:])"
    script(tools.workspace / "install/tools", "foreign", f"#!{shebang}\n{tell}\n")
    answer = tools("run", "tools", "foreign", "x")
    executable, argument = answer.stdout.split()
    assert (Path(executable).parent, argument) == (tools.python.parent, "x")
    assert answer.stderr.count("\n") == 1
    assert "python" in answer.stderr


def test_a_script_of_this_python_is_left_alone(tools: Ros2) -> None:
    script(tools.workspace / "install/tools", "ours", f"#!{tools.python}\nprint('hello')\n")
    answer = tools("run", "tools", "ours")
    assert (answer.stdout, answer.stderr) == ("hello\n", "")


def _both(pid: int, number: int) -> None:
    """As `timeout` does it."""
    os.kill(pid, number)
    os.killpg(pid, number)


@pytest.mark.slow
@pytest.mark.parametrize("send", [os.kill, os.killpg, _both], ids=["ros2 alone", "the group", "both"])
def test_sigint_reaches_the_node_once(send: Callable[[int, int], None], tools: Ros2) -> None:
    with tools.started("run", "tools", "counting") as process:
        assert _line(process) == "ready\n"
        send(process.pid, signal.SIGINT)
        assert _rest(process) == "got 2\n[ros2run]: Process exited with failure 3\n"
        assert process.wait(10) == 3


@pytest.mark.slow
def test_sigint_reaches_the_node_once_on_a_busy_machine(tools: Ros2) -> None:
    """What ros2 has beside it to see what the group gets has to wait for its turn."""
    with tools.started("run", "tools", "counting") as process:
        assert _line(process) == "ready\n"
        (witness,) = (one for one in psutil.Process(process.pid).children() if "ros2cli" in one.cmdline())
        witness.suspend()
        os.killpg(process.pid, signal.SIGINT)
        assert _line(process) == "got 2\n"
        witness.resume()
        assert process.wait(10) == 3


@pytest.mark.slow
@pytest.mark.parametrize("send", [os.kill, os.killpg], ids=["ros2 alone", "the group"])
def test_sigterm_ends_both(send: Callable[[int, int], None], tools: Ros2) -> None:
    """The real one leaves the node behind when only ros2 gets it."""
    with tools.started("run", "tools", "counting") as process:
        assert _line(process) == "ready\n"
        send(process.pid, signal.SIGTERM)
        assert _rest(process) == "got 15\n"
        assert process.wait(10) == -signal.SIGTERM


@pytest.mark.slow
def test_ctrl_c_on_a_terminal_reaches_the_node_once(tools: Ros2) -> None:
    command, *arguments = tools.line("run", "tools", "counting")
    terminal = pexpect.spawn(command, arguments, env=dict(tools.environment), timeout=20, encoding="utf-8")
    terminal.expect_exact("ready")
    terminal.sendintr()
    terminal.expect(r"got ([\d ]+)\r\n")
    assert terminal.match.group(1) == "2"
    terminal.expect(pexpect.EOF)
    terminal.close()
    assert terminal.exitstatus == 3


@pytest.mark.slow
def test_the_node_dies_with_a_killed_ros2(tools: Ros2) -> None:
    with tools.started("run", "tools", "sleeping") as process:
        node = psutil.Process(int(_line(process)))
        process.kill()
        node.wait(10)  # TimeoutExpired when it lives on
        assert _rest(process) == ""  # nobody is left who could write


def test_nothing_is_left_when_the_node_ends(tools: Ros2) -> None:
    with tools.started("run", "tools", "sleeping") as process:
        node = int(_line(process))
        beside = psutil.Process(process.pid).children(recursive=True)
        assert len(beside) == 2
        os.kill(node, signal.SIGKILL)
        assert process.wait(10) == 256 - signal.SIGKILL
        assert _rest(process) == "[ros2run]: Killed\n"
        assert not any(map(_is_alive, beside))


def test_under_nohup_the_node_ignores_sighup(tools: Ros2) -> None:
    tell = "import signal; print(*(int(signal.getsignal(n)) for n in (signal.SIGHUP, signal.SIGTERM)))"
    script(tools.workspace / "install/tools", "told", f"#!{tools.python}\n{tell}\n")
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        answer = tools("run", "tools", "told")
    finally:
        signal.signal(signal.SIGHUP, before)
    assert answer.stdout == f"{int(signal.SIG_IGN)} {int(signal.SIG_DFL)}\n"


@pytest.mark.slow
@pytest.mark.parametrize("send", [os.kill, os.killpg], ids=["ros2 alone", "the group"])
def test_a_node_of_rclpy_ends_cleanly(send: Callable[[int, int], None], ros2: Ros2) -> None:
    case = capture("run_ok_spins")
    with isolated(namespaces=False) as place:
        quiet = replace(ros2, environment={**ros2.environment, **place.environment})
        with quiet.started(*case.arguments) as process:
            printed = [_line(process) for _ in range(3)]
            send(process.pid, signal.SIGINT)
            rest = _rest(process)
            assert process.wait(10) == case.code
    assert "Traceback" not in rest
    assert [_message(line) for line in printed] == [_message(line) for line in case.stderr.splitlines()]


@pytest.mark.slow
def test_it_takes_little_longer_than_the_node_itself(tools: Ros2) -> None:
    began = time.monotonic()
    for _ in range(5):
        tools("run", "tools", "tell")
    assert (time.monotonic() - began) / 5 < 3.0  # about 0.13 s on a quiet machine


def _line(process: subprocess.Popen[str]) -> str:
    assert process.stdout
    return process.stdout.readline()


def _rest(process: subprocess.Popen[str]) -> str:
    assert process.stdout
    return process.stdout.read()


def _message(line: str) -> str:
    """A log line without its time."""
    return line.split("]: ")[1].strip()


def _is_alive(process: psutil.Process) -> bool:
    return process.is_running() and process.status() != psutil.STATUS_ZOMBIE
