"""What the launcher sets up, when, and with what; and that it hands over to the course."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.launcher.machine import Machine

PIP = "pip -I -m pip install --no-input --disable-pip-version-check --progress-bar off --editable"


def test_the_first_call_sets_up_and_runs_the_course(machine: Machine) -> None:
    result = machine.run("check", "18-publisher")
    assert result.returncode == 0, result.stderr
    venv = machine.clone / ".venv"
    assert machine.calls() == [
        f"venv -I -m venv {venv}",
        f"{PIP} .[jazzy]",
        f"run in {machine.clone} with 1:",
        "  <check>",
        "  <18-publisher>",
    ]
    assert result.stdout == ""  # kept free for the course: `check --json` is read by programs
    assert "setting up in" in result.stderr and "ready" in result.stderr


def test_later_calls_only_run_the_course(machine: Machine) -> None:
    machine.run()
    result = machine.run()
    assert result.stderr == ""
    assert len(machine.calls("pip")) == len(machine.calls("venv")) == 1
    assert len(machine.calls("run")) == 2


def test_arguments_exit_code_and_folder_are_passed_on(machine: Machine, tmp_path: Path) -> None:
    (machine.fake / "exit_code").write_text("3")
    result = machine.run("two words", "", "*", "--setup-only", "$HOME", cwd=tmp_path)
    assert result.returncode == 3
    assert machine.calls()[2:] == [
        f"run in {tmp_path} with 1:",
        "  <two words>",
        "  <>",
        "  <*>",
        "  <--setup-only>",
        "  <$HOME>",
    ]


def test_it_may_be_called_through_a_link(machine: Machine, tmp_path: Path) -> None:
    folder = tmp_path / "links"
    folder.mkdir()
    (folder / "first").symlink_to(machine.clone / "ros2course")
    (folder / "second").symlink_to("first")
    assert machine.run(launcher=folder / "second", cwd=tmp_path).returncode == 0
    assert (machine.clone / ".venv/.ros2course").exists()


def test_setup_only_brings_extras_and_runs_nothing(machine: Machine) -> None:
    assert machine.run("--setup-only", "test").returncode == 0
    assert machine.calls("pip") == [f"{PIP} .[jazzy,test]"]
    assert machine.calls("run") == []


def test_extras_are_added_to_an_environment_and_kept(machine: Machine) -> None:
    machine.run()
    machine.run("--setup-only", "test")
    machine.run()
    assert machine.calls("pip") == [f"{PIP} .[jazzy]", f"{PIP} .[jazzy,test]"]
    change_project(machine)
    machine.run()
    assert machine.calls("pip")[2:] == [f"{PIP} .[jazzy,test]"]
    assert len(machine.calls("venv")) == 1


def test_a_changed_project_is_installed_again_into_the_same_environment(machine: Machine) -> None:
    machine.run()
    change_project(machine)
    result = machine.run()
    assert "up to date" in result.stderr
    assert (len(machine.calls("venv")), len(machine.calls("pip"))) == (1, 2)


def test_a_moved_clone_gets_a_new_environment(machine: Machine) -> None:
    machine.run()
    machine.clone = machine.clone.rename(machine.clone.with_name("moved"))
    machine.run()
    assert len(machine.calls("venv")) == 2
    assert machine.calls()[-1] == f"run in {machine.clone} with 1:"


def test_an_environment_whose_python_is_gone_is_made_anew(machine: Machine) -> None:
    machine.run()
    (machine.clone / ".venv/bin/python").unlink()
    assert machine.run().returncode == 0
    assert len(machine.calls("venv")) == 2


def test_an_environment_of_somebody_else_is_left_alone(machine: Machine) -> None:
    theirs = machine.clone / ".venv/pyvenv.cfg"
    theirs.parent.mkdir()
    theirs.write_text("mine")
    result = machine.run()
    assert result.returncode == 4
    assert "was not made by this command" in result.stderr and "mv '" in result.stderr
    assert theirs.read_text() == "mine"
    assert machine.calls() == []


def test_another_python_is_taken_when_python3_is_too_old(machine: Machine) -> None:
    machine.python("python3", version="3.9")
    machine.python("python3.12", version="3.12")
    result = machine.run()
    assert result.returncode == 0
    assert "python3.12 (Python 3.12)" in result.stderr


def test_pip_is_not_sent_elsewhere(machine: Machine) -> None:
    body = (machine.bin / "python3").read_text()
    marked = body.replace('echo "pip $*"', 'echo "pip ${PIP_USER-} ${PIP_TARGET-}"')
    assert marked != body
    (machine.bin / "python3").write_text(marked)
    machine.run(PIP_USER="1", PIP_TARGET="/elsewhere")
    assert machine.calls("pip") == ["pip  "]


@pytest.mark.parametrize("sourced", [True, False])
def test_an_installed_ros_brings_its_python_and_no_wheels(machine: Machine, sourced: bool) -> None:
    prefix = machine.ros(machine.opt_ros, python="3.12")
    machine.python("system-python3", version="3.12")
    machine.python("python3", version="3.13")
    sourced_ros = {"ROS_DISTRO": "jazzy", "AMENT_PREFIX_PATH": f"/my/overlay:{prefix}"}
    assert machine.run(**(sourced_ros if sourced else {})).returncode == 0
    assert machine.calls("venv") == [f"venv -I -m venv --system-site-packages {machine.clone}/.venv"]
    assert machine.calls("pip") == [f"{PIP} ."]


def test_sourcing_an_installed_ros_or_not_is_the_same_environment(machine: Machine) -> None:
    prefix = machine.ros(machine.opt_ros)
    machine.python("system-python3")
    machine.run()
    machine.run(ROS_DISTRO="jazzy", AMENT_PREFIX_PATH=str(prefix))
    assert len(machine.calls("pip")) == 1


def test_a_sourced_ros_elsewhere_is_used_by_the_python_that_imports_rclpy(machine: Machine) -> None:
    prefix = machine.ros(machine.clone.parent / "robostack", python="no")
    sourced = {"ROS_DISTRO": "jazzy", "AMENT_PREFIX_PATH": str(prefix)}
    result = machine.run(**sourced)
    assert result.returncode == 4
    assert "no Python here can import rclpy" in result.stderr
    (machine.fake / "can_import_rclpy").touch()
    assert machine.run(**sourced).returncode == 0
    assert machine.calls("pip") == [f"{PIP} ."]


def test_the_wheels_sourced_by_the_courses_own_shell_are_no_other_ros(machine: Machine) -> None:
    machine.run()
    venv = machine.ros(machine.clone / ".venv")
    machine.run(ROS_DISTRO="jazzy", AMENT_PREFIX_PATH=str(venv))
    assert len(machine.calls("pip")) == 1


def test_another_ros_means_another_environment_and_says_why(machine: Machine) -> None:
    machine.run()
    machine.ros(machine.opt_ros)
    machine.python("system-python3")
    result = machine.run()
    assert "the environment was for ROS 2 from pip, in " in result.stderr
    assert f"; now it is for ROS 2 from {machine.opt_ros}" in result.stderr
    assert len(machine.calls("venv")) == 2


def test_the_environment_names_the_python_behind_a_link(machine: Machine) -> None:
    """`python3` may be another Python after an upgrade of the system."""
    real = machine.bin / "python3"
    result = machine.run()
    assert f"with {os.path.realpath(real)}" in result.stderr


def change_project(machine: Machine) -> None:
    with (machine.clone / "pyproject.toml").open("a") as file:
        file.write("# a new dependency\n")
