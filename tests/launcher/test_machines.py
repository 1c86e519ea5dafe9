"""Machines on which the course cannot be set up: reported before anything is installed, with advice."""

from __future__ import annotations

import pytest

from tests.launcher.machine import Machine


@pytest.mark.parametrize(
    ("system", "processor"),
    [("Linux", "aarch64"), ("Linux", "i686"), ("Darwin", "arm64"), ("Darwin", "x86_64")],
)
def test_another_processor_or_system(machine: Machine, system: str, processor: str) -> None:
    machine.uname(system, processor)
    refused(machine, f"This machine: {system} on {processor}.", "Ubuntu 24.04", "docker run -it ros:jazzy")


@pytest.mark.parametrize(
    ("version", "serves"),
    [("2.7", False), ("3.9", False), ("3.10", True), ("3.14", True), ("3.15", False), ("4.12", False)],
)
def test_versions_of_python(machine: Machine, version: str, serves: bool) -> None:
    machine.python("python3", version=version)
    if serves:
        assert machine.run().returncode == 0
    else:
        refused(machine, f"python3 is {version}", "Python 3.10 to 3.14", "install a Python that fits")


@pytest.mark.parametrize(
    ("libc", "serves"),
    [("musl", False), ("glibc-2.27", False), ("glibc-2.28", True), ("glibc-2.41", True), ("unknown", False)],
)
def test_c_libraries(machine: Machine, libc: str, serves: bool) -> None:
    machine.python("python3", libc=libc)
    if serves:
        assert machine.run().returncode == 0
    else:
        refused(machine, f"python3 is made for {libc}", "glibc 2.28 or newer", "Ubuntu 24.04")


@pytest.mark.parametrize("kind", ["pypy", "32-bit", "free-threaded"])
def test_other_kinds_of_python(machine: Machine, kind: str) -> None:
    machine.python("python3", kind=kind)
    refused(machine, f"python3 is {kind}")


def test_no_python_at_all(machine: Machine) -> None:
    (machine.bin / "python3").unlink()
    refused(machine, "there is no Python 3 here", "python3-venv")


def test_a_command_that_only_pretends_to_be_a_python(machine: Machine) -> None:
    """Version managers put a python3.12 on the PATH that only says that it is not installed."""
    machine.script("python3", "echo 'not installed' >&2; exit 127")
    refused(machine, "there is no Python 3 here")


def test_a_python_without_venv_names_the_package(machine: Machine) -> None:
    machine.python("python3", version="3.12", venv=False)
    machine.script("apt-get", "exit 1")
    refused(machine, "lacks its venv module", "sudo apt-get install python3.12-venv")


def test_a_python_without_venv_is_passed_over_for_one_with_it(machine: Machine) -> None:
    machine.python("python3", version="3.12", venv=False)
    machine.python("python3.11")
    result = machine.run()
    assert result.returncode == 0
    assert "python3.11 (Python 3.11)" in result.stderr


def test_a_ros_that_is_there_makes_the_processor_no_matter(machine: Machine) -> None:
    machine.uname("Linux", "aarch64")
    machine.python("python3", version="3.15", libc="musl")
    machine.ros(machine.opt_ros, python="3.15")
    machine.python("system-python3", version="3.15")
    assert machine.run().returncode == 0


def test_a_ros_whose_python_is_too_old(machine: Machine) -> None:
    machine.ros(machine.opt_ros, python="3.8")
    machine.python("system-python3", version="3.8")
    refused(machine, "uses Python 3.8", "Use a newer ROS 2")


def test_a_ros_whose_python_has_no_venv(machine: Machine) -> None:
    machine.ros(machine.opt_ros, python="3.12")
    machine.python("system-python3", version="3.12", venv=False)
    refused(machine, "python3.12-venv")


def refused(machine: Machine, *says: str) -> None:
    result = machine.run("next")
    assert result.returncode == 4
    for text in says:
        assert text in result.stderr
    assert "Next: " in result.stderr
    assert result.stdout == ""
    lines = result.stderr.replace(str(machine.clone.parent), "").splitlines()
    assert [line for line in lines if len(line) > 80] == []
    assert machine.calls() == []
    assert not (machine.clone / ".venv").exists()
