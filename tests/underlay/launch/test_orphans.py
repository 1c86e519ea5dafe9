"""However a launch ends, nothing of it is left: with the kernel's help, and where `setpriv` is not there."""

from __future__ import annotations

import contextlib
import os
import re
import shutil
import signal
from functools import partial
from pathlib import Path

import psutil
import pytest

from tests.underlay.launch.machine import Answer, Launcher, Running, alive, comes_true, gone

STUBBORN = "trap '' INT TERM HUP; echo ready >&2; while :; do sleep 0.05; done"
PROCESSES = f"""
    ExecuteProcess(cmd=['sleep', '100']),
    ExecuteProcess(cmd=['sleep 100 && true'], shell=True, name='shell'),
    ExecuteProcess(cmd=['sh', '-c', "{STUBBORN}"], name='mule', sigterm_timeout='0.1', sigkill_timeout='0.1'),
"""
BARE = "ExecuteProcess(cmd=['sleep', '100']), ExecuteProcess(cmd=['sleep', '100'], emulate_tty=True),"


@pytest.fixture(params=["with setpriv", "without setpriv"])
def path(request: pytest.FixtureRequest, tmp_path: Path) -> str:
    """The PATH of a machine that has it, or has it not."""
    if request.param == "with setpriv":
        if shutil.which("setpriv") is None:
            pytest.skip("this machine has no setpriv")
        return os.environ["PATH"]
    return _without_setpriv(tmp_path / "bin")


def _without_setpriv(folder: Path) -> str:
    folder.mkdir()
    for name in ("sh", "sleep", "env", "true", "yes"):
        (folder / name).symlink_to(shutil.which(name) or "")
    return str(folder)


def _descendants(running: Running) -> list[psutil.Process]:
    return psutil.Process(running.process.pid).children(recursive=True)


def _killed(launcher: Launcher, path: str, entities: str, started: str, least: int) -> None:
    """Start these, kill the launch alone once it has so many processes: all of them end."""
    with launcher.started(launcher.description(entities), PATH=path) as running:
        running.wait_for(started)
        there: list[psutil.Process] = []

        def enough() -> bool:
            there[:] = _descendants(running)
            return len(there) >= least

        assert comes_true(enough)
        running.signal(signal.SIGKILL)
        running.process.wait(timeout=20)
        assert all(gone(process.pid) for process in there), there


@pytest.mark.slow
def test_a_killed_launch_leaves_nothing_behind(launcher: Launcher, path: str) -> None:
    _killed(launcher, path, BARE, "[sleep-2]: process started", 3)  # the two, and the one that watches


@pytest.mark.slow
def test_killed_while_processes_are_being_started(launcher: Launcher, path: str) -> None:
    """A program that is half started is not forgotten: it is not yet `sleep`, but in the launch's session."""
    entities = "*[ExecuteProcess(cmd=['sleep', '100']) for _ in range(20)]"
    for number in range(1, 9):
        with launcher.started(launcher.description(entities), PATH=path) as running:
            running.wait_for(f"[sleep-{number}]: process started")
            running.process.kill()  # the launch alone
            running.process.wait(timeout=20)
            assert comes_true(partial(_nobody_is_in, running.process.pid)), _sleepers_and_guards()


def _nobody_is_in(session: int) -> bool:
    for pid in psutil.pids():
        with contextlib.suppress(ProcessLookupError):
            if os.getsid(pid) == session and alive(pid):
                return False
    return True


def _sleepers_and_guards() -> list[dict[str, object]]:
    everybody = psutil.process_iter(["pid", "ppid", "status", "cmdline"])
    return [one.info for one in everybody if re.search(r"'sleep'|guard_program", str(one.info["cmdline"]))]


@pytest.mark.slow
def test_not_even_what_processes_have_started_is_left(launcher: Launcher, path: str) -> None:
    # Three processes, the shell's own, and the one that watches.
    _killed(launcher, path, PROCESSES, "[mule-3] ready", 5)


def _ended_by(launcher: Launcher, path: str, number: signal.Signals) -> Answer:
    with launcher.started(launcher.description(PROCESSES), PATH=path) as running:
        running.wait_for("[mule-3] ready")
        there = _descendants(running)
        running.signal(number)
        answer = running.finish()
        assert all(gone(process.pid) for process in there), there
    return answer


@pytest.mark.slow
@pytest.mark.parametrize(
    "number", [signal.SIGTERM, signal.SIGINT, signal.SIGQUIT], ids=lambda each: each.name
)
def test_a_launch_that_is_told_to_end_leaves_nothing_behind(
    launcher: Launcher, path: str, number: signal.Signals
) -> None:
    """Told alone: what its processes have started is ended as well where a shell stands between."""
    answer = _ended_by(launcher, path, number)
    assert "escalating to 'SIGKILL'" in answer.stdout
    assert answer.code == (0 if number == signal.SIGINT else -number)


@pytest.mark.parametrize("later", ["Node(package='nosuch', executable='x')", "LogInfo(msg=ThisIsNone())"])
def test_a_mistake_further_down_ends_what_was_begun(launcher: Launcher, path: str, later: str) -> None:
    before = "class ThisIsNone(Substitution):\n    def perform(self, context):\n        return None\n"
    answer = launcher(launcher.description(f"{BARE} {later}", before), PATH=path)
    assert (answer.code, answer.stderr) == (1, "")
    assert "Caught exception in launch (see debug for traceback)" in answer.said[0]
    assert not [
        process for process in psutil.process_iter(["cwd"]) if process.info["cwd"] == str(launcher.cwd)
    ]


@pytest.mark.slow
def test_a_flood_of_output_does_not_delay_the_end(launcher: Launcher) -> None:
    flood = "ExecuteProcess(cmd=['yes', 'x'], output={}, sigterm_timeout='20'),"
    path = launcher.description(flood.format("'screen'") + flood.format("'both'"))
    with launcher.started(path) as running:
        running.wait_for("[yes-2] x", times=10)
        running.signal(signal.SIGINT)
        answer = running.finish()
    assert "failed to terminate" not in answer.stdout
    assert "[INFO] [yes-1]: sending signal 'SIGINT' to process[yes-1]" in answer.said
    assert {line for line in answer.of("yes-1")} == {"x"}
    assert answer.code == 0
