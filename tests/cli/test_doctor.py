"""`doctor`: what is missing gets an exact next step."""

from __future__ import annotations

import shutil
import time
from collections import namedtuple
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from course import isolation
from course.cli import doctor
from course.errors import MissingHere
from course.isolation import Level
from course.isolation.isolation_plan import Restriction
from course.report.problem import MachineFinding, State

if TYPE_CHECKING:
    from tests.cli.conftest import Ros2course


Usage = namedtuple("Usage", "total used free")
ROS = MachineFinding("ROS 2", State.OK, "jazzy")


@pytest.fixture
def only(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """A PATH with nothing but what a test puts there."""
    folder = tmp_path / "only"
    folder.mkdir()
    monkeypatch.setenv("PATH", str(folder))
    return folder


def put_program(folder: Path, name: str, says: str = "1.0") -> None:
    (folder / name).write_text(f"#!/bin/sh\necho {says}\n")
    (folder / name).chmod(0o755)


def test_a_missing_program_is_named_with_its_command(only: Path) -> None:
    put_program(only, "apt-get")
    found = doctor.program("g++", "g++")
    assert (found.state, found.next_step) == (State.MISSING, "Install it: `sudo apt install g++`")


def test_without_apt_the_package_is_named(only: Path) -> None:
    assert "system's package manager" in (doctor.program("g++", "g++").next_step or "")


def test_a_program_that_is_there_says_its_version(only: Path) -> None:
    put_program(only, "g++", "g++ 12.2")
    assert doctor.program("g++", "g++") == MachineFinding("g++", State.OK, f"g++ 12.2, {only / 'g++'}")


def test_a_program_that_does_not_start_is_no_crash(only: Path) -> None:
    (only / "g++").write_bytes(b"\x7fELF nonsense")
    (only / "g++").chmod(0o755)
    assert "does not start" in doctor.program("g++", "g++").found


def test_no_ros_says_what_its_error_says(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing() -> None:
        raise MissingHere("There is no ROS 2.", "source it")

    monkeypatch.setattr("course.cli.doctor.find_ros", missing)
    assert doctor.ros() == MachineFinding("ROS 2", State.MISSING, "There is no ROS 2.", "source it")


def test_no_bubblewrap_is_no_obstacle(only: Path) -> None:
    found = doctor.containment()
    assert found.state is State.LESS
    assert "bubblewrap is not installed" in found.found
    assert "--no-sandbox" in (found.next_step or "")


def test_full_containment_says_how_it_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(doctor, "obstacle_to", lambda level: None)
    for available, words in ((True, "(control groups)"), (False, "are only watched")):
        monkeypatch.setattr(doctor, "available", lambda available=available: available)
        found = doctor.containment()
        assert found.state is State.OK
        assert words in found.found


def test_a_restriction_of_the_system_is_named_with_its_remedy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(doctor, "obstacle_to", lambda level: "not allowed")
    found_one = Restriction("It is off.", "Do this.")
    monkeypatch.setattr(isolation.ISOLATION, "restriction", lambda: found_one)
    found = doctor.containment()
    assert (found.state, found.found) == (State.LESS, "not allowed. It is off.")
    assert (found.next_step or "").startswith("Do this. Checks of your own code work")


def test_one_layer_is_said_to_be_one(monkeypatch: pytest.MonkeyPatch) -> None:
    lacking = {Level.CONTAINED: "copy that pointer"}
    monkeypatch.setattr(doctor, "obstacle_to", lacking.get)
    monkeypatch.setattr(isolation.ISOLATION, "restriction", lambda: None)
    assert doctor.containment().found == "one layer of two: copy that pointer"


@pytest.mark.parametrize(("free", "state"), [(5.0, State.OK), (1.0, State.LESS), (0.1, State.MISSING)])
def test_a_full_disk_is_seen(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, free: float, state: State
) -> None:
    monkeypatch.setattr(shutil, "disk_usage", lambda _: Usage(0, 0, free * 2**30))
    assert doctor.storage("cache", tmp_path).state is state


def test_a_folder_that_cannot_be_written_is_seen() -> None:
    found = doctor.storage("cache", Path("/dev/null/cache"))
    assert found.state is State.MISSING
    assert "ls -ld /dev/null/cache" in (found.next_step or "")


def test_a_clock_of_the_past_is_seen(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(time, "time", lambda: 1_000_000.0)
    found = doctor.clock(tmp_path)
    assert found.state is State.MISSING
    assert "date -s" in (found.next_step or "")


def test_a_disk_with_another_clock_is_seen(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    now = time.time()
    monkeypatch.setattr(time, "time", lambda: now + 3600)
    found = doctor.clock(tmp_path)
    assert found.state is State.LESS
    assert "3600 s off" in found.found


def test_doctor_ends_with_4_only_when_something_needed_is_missing(
    ros2course: Ros2course, home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("ros", "colcon", "containment"):
        monkeypatch.setattr(doctor, name, lambda: ROS)
    monkeypatch.setattr(doctor, "program", lambda name, package: MachineFinding(name, State.OK, "here"))
    without_home = ros2course("doctor")
    assert without_home.code == 0
    assert "-> `ros2course next` creates one." in without_home.out
    monkeypatch.setattr(doctor, "ros", lambda: MachineFinding("ROS 2", State.MISSING, "none", "install it"))
    run = ros2course("doctor")
    assert run.code == 4
    assert "Something that is needed is missing: ROS 2." in run.out


@pytest.mark.slow
def test_this_very_machine_is_described(ros2course: Ros2course, home: Path) -> None:
    ros2course("init")
    run = ros2course("doctor")
    for name in ("ROS 2", "Python", "colcon", "g++", "cmake", "containment", "course home", "cache", "clock"):
        assert f"  {name} " in run.out
    assert home.name in "".join(run.out.split())  # a long path is wrapped anywhere
