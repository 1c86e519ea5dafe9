"""The next call finishes a setup that was stopped anywhere; two at once do the work once."""

from __future__ import annotations

import os
import signal
import subprocess

import pytest

from tests.launcher.machine import GUARD, Machine, finish


def test_ctrl_c_says_what_next_and_the_next_call_finishes(machine: Machine) -> None:
    machine.pip_waits()
    first = machine.start()
    machine.until_pip_started()
    os.killpg(first.pid, signal.SIGINT)
    result = finish(first)
    assert result.returncode == 130
    assert "The next ./ros2course finishes it" in result.stderr
    again(machine)


def test_killed_while_pip_runs(machine: Machine) -> None:
    machine.pip_waits()
    first = machine.start()
    machine.until_pip_started()
    os.killpg(first.pid, signal.SIGKILL)
    finish(first)
    again(machine)


def test_killed_while_the_environment_is_made(machine: Machine) -> None:
    (machine.fake / "venv_dies").touch()
    assert machine.run().returncode == -signal.SIGKILL
    assert (machine.clone / ".venv/pyvenv.cfg").exists()
    (machine.fake / "venv_dies").unlink()
    assert machine.run().returncode == 0
    assert len(machine.calls("run")) == 1


def test_killed_while_a_half_made_environment_is_removed(machine: Machine) -> None:
    venv = machine.clone / ".venv"
    venv.mkdir()
    for name in (".ros2course", "pyvenv.cfg"):
        (venv / name).write_text("unfinished\n\n\n")
    rm = machine.bin / "rm"
    real = rm.readlink()
    rm.unlink()
    dies = f'{real} "$2/.ros2course"; kill -KILL 0'
    machine.script("rm", f'case $1 in -rf) {dies} ;; *) exec {real} "$@" ;; esac')
    assert machine.run().returncode == -signal.SIGKILL
    machine.script("rm", f'exec {real} "$@"')
    assert machine.run().returncode == 0


def test_killed_while_an_environment_is_brought_up_to_date(machine: Machine) -> None:
    machine.run()
    (machine.clone / "pyproject.toml").write_text("# changed\n")
    machine.pip_waits()
    first = machine.start()
    machine.until_pip_started()
    os.killpg(first.pid, signal.SIGKILL)
    finish(first)
    again(machine, pips=3)
    assert len(machine.calls("venv")) == 2  # what a killed pip leaves half installed is not built upon


@pytest.mark.parametrize("left", ["nothing", "folder", "stamp", "environment", "no pyvenv.cfg"])
def test_whatever_a_killed_setup_leaves_is_finished(machine: Machine, left: str) -> None:
    venv = machine.clone / ".venv"
    if left != "nothing":
        venv.mkdir()
    if left in ("stamp", "environment"):
        (venv / ".ros2course").write_text("unfinished\n\n\n")
    if left == "environment":
        (venv / "pyvenv.cfg").touch()
    if left == "no pyvenv.cfg":
        (venv / "lib/python3.11").mkdir(parents=True)
    assert machine.run().returncode == 0
    assert len(machine.calls("run")) == 1


def test_a_failed_download_is_tried_again(machine: Machine) -> None:
    (machine.fake / "pip_fails").touch()
    (machine.fake / "pip_prints").write_text("a\n" * 20 + "Temporary failure in name resolution\n")
    result = machine.run()
    assert result.returncode == 4
    assert "could not be downloaded" in result.stderr and "Next: " in result.stderr
    assert result.stderr.count("    a\n") == 11  # the end of the log, not all of it
    assert (machine.clone / ".venv-setup.log").read_text().count("a\n") == 20
    (machine.fake / "pip_fails").unlink()
    assert machine.run().returncode == 0
    assert len(machine.calls("pip")) == 2


def test_a_full_disk_is_named(machine: Machine) -> None:
    (machine.fake / "pip_fails").touch()
    (machine.fake / "pip_prints").write_text("OSError: [Errno 28] No space left on device\n")
    result = machine.run()
    assert result.returncode == 4
    assert "the disk is full" in result.stderr


def test_a_folder_that_cannot_be_written_to_is_named(machine: Machine) -> None:
    # Root may write anywhere, so a folder stands where the file should be.
    (machine.clone / ".venv-setup.log").mkdir()
    result = machine.run()
    assert result.returncode == 4
    assert "cannot write to" in result.stderr
    assert machine.calls() == []


def test_two_at_once_set_up_once(machine: Machine) -> None:
    machine.pip_waits()
    first = machine.start("a")
    machine.until_pip_started()
    second = machine.start("b")
    assert said(second) == "ros2course: another call is setting up; waiting for it\n"
    machine.let_pip_go()
    assert [finish(first).returncode, finish(second).returncode] == [0, 0]
    assert len(machine.calls("pip")) == 1
    assert len(machine.calls("run")) == 2


def test_a_setup_whose_launcher_was_killed_is_waited_for(machine: Machine) -> None:
    """pip continues alone; nobody may remove its environment meanwhile."""
    machine.pip_waits()
    first = machine.start()
    machine.until_pip_started()
    first.kill()
    first.wait(GUARD)
    second = machine.start()
    assert said(second).endswith("waiting for it\n")
    assert len(machine.calls("venv")) == 1
    machine.let_pip_go()
    assert finish(second).returncode == 0
    assert len(machine.calls("run")) == 1


def test_ctrl_c_while_waiting_for_another_setup(machine: Machine) -> None:
    machine.pip_waits()
    first = machine.start()
    machine.until_pip_started()
    second = machine.start()
    said(second)
    os.killpg(second.pid, signal.SIGINT)
    result = finish(second)
    assert result.returncode == 130
    assert "Traceback" not in result.stderr
    machine.let_pip_go()
    assert finish(first).returncode == 0


def again(machine: Machine, pips: int = 2) -> None:
    """The next call, with a pip that does not wait, finishes the job and runs the course."""
    (machine.fake / "pip_waits").unlink()
    result = machine.run()
    assert result.returncode == 0, result.stderr
    assert len(machine.calls("pip")) == pips
    assert machine.calls("run")
    assert machine.run().stderr == ""


def said(process: subprocess.Popen[str]) -> str:
    return process.stderr.readline()
