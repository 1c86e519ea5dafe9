"""A program that runs for a build ends completely, whatever it does."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import psutil
import pytest

from course.build import Interrupt, Interrupted, runner
from course.build.runner import Ended, Ending, run
from tests.build.conftest import called_off

REPO = Path(__file__).parents[2]

# Starts a long-lived child, reports it, and then does what the rest of the line says.
PARENT = "sleep 300 & : > child; "


@pytest.fixture
def shell(tmp_path: Path) -> Callable[..., Ended]:
    def run_shell(script: str, *, interrupt: Interrupt | None = None, time_limit: float = 30.0) -> Ended:
        with Interrupt(interrupt) as stop:
            return run(
                None,
                ["/bin/sh", "-c", script],
                cwd=tmp_path,
                env={"PATH": os.defpath},
                output=tmp_path / "output",
                time_limit=time_limit,
                interrupt=stop,
            )

    return run_shell


def gone(folder: Path) -> bool:
    """Whether everything that ran in the folder has ended, after a moment."""
    psutil.wait_procs(running_in(folder), 10)
    return not running_in(folder)


def running_in(folder: Path) -> list[psutil.Process]:
    return [one for one in psutil.process_iter(["cwd"]) if one.info["cwd"] == str(folder)]


def test_output_and_code_are_kept(shell: Callable[..., Ended], tmp_path: Path) -> None:
    ended = shell("echo out; echo err >&2; exit 7")
    assert (ended.ending, ended.code) == (Ending.EXITED, 7)
    assert (tmp_path / "output").read_text().split() == ["out", "err"]


def test_all_output_is_kept(shell: Callable[..., Ended], tmp_path: Path) -> None:
    shell("seq 200000")
    assert (tmp_path / "output").read_text().endswith("\n200000\n")


def test_it_reads_nothing_from_the_terminal(shell: Callable[..., Ended]) -> None:
    assert shell("read line").code != 0


@pytest.mark.slow
def test_what_it_leaves_running_is_killed(shell: Callable[..., Ended], tmp_path: Path) -> None:
    ended = shell(PARENT + "exit 0")
    assert ended.code == 0
    assert ended.seconds < 20
    assert gone(tmp_path)


@pytest.mark.slow
def test_a_time_limit_ends_everything(shell: Callable[..., Ended], tmp_path: Path) -> None:
    ended = shell(PARENT + "trap '' TERM INT; wait", time_limit=0.5)
    assert ended.ending is Ending.TOO_LONG
    assert gone(tmp_path)


def test_a_flood_is_stopped(
    shell: Callable[..., Ended], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(runner, "MOST_OUTPUT", 1 << 20)
    assert shell("yes").ending is Ending.TOO_MUCH_OUTPUT
    assert (tmp_path / "output").stat().st_size < 2 << 20


@pytest.mark.slow
def test_calling_off_ends_everything(shell: Callable[..., Ended], tmp_path: Path) -> None:
    began = time.monotonic()
    with called_off((tmp_path / "child").exists) as interrupt, pytest.raises(Interrupted):
        shell(PARENT + "wait", interrupt=interrupt)
    assert time.monotonic() - began < 20
    assert gone(tmp_path)


KILLED = """
import sys
from pathlib import Path
from course.build import Interrupt
from course.build.runner import run
folder = Path(sys.argv[1])
with Interrupt() as interrupt:
    run(None, ["/bin/sh", "-c", "sleep 300 & : > child; wait"], cwd=folder,
        env={"PATH": "/usr/bin:/bin"}, output=folder / "output", time_limit=100, interrupt=interrupt)
"""


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGTERM, signal.SIGINT])
def test_when_we_are_killed_it_ends_too(tmp_path: Path, number: signal.Signals) -> None:
    ours = subprocess.Popen(
        [sys.executable, "-c", KILLED, str(tmp_path)], cwd=REPO, stderr=subprocess.DEVNULL
    )
    while not (tmp_path / "child").exists():
        assert ours.poll() is None
        time.sleep(0.02)
    ours.send_signal(number)
    ours.wait(10)
    assert gone(tmp_path)


@pytest.mark.parametrize("isolated", [True, False])
def test_nothing_begins_when_we_are_gone_already(isolated: bool) -> None:
    """The kernel signals only those who asked earlier. A bubblewrap that nobody listens to hangs forever."""
    late = 'while kill -0 "$0" 2>/dev/null; do sleep 0.01; done; exec "$@"'
    code = (
        "import os, subprocess, sys\nfrom course.build.runner import _guarded\n"
        "from course.isolation import IsolationPlan\nfrom course.isolation.bubblewrap import with_us\n"
        "command = ['/bin/sh', '-c', 'echo begun']\n"
        f"command = [*with_us(IsolationPlan()), *command] if {isolated} else _guarded(command)\n"
        f"subprocess.Popen(['/bin/sh', '-c', {late!r}, str(os.getpid()), *command])\n"
    )
    starting = subprocess.Popen([sys.executable, "-c", code], cwd=REPO, stdout=subprocess.PIPE)
    assert starting.wait(60) == 0
    assert starting.communicate(timeout=60)[0] == b""
