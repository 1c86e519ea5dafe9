"""Nodes in a shared library, with programs of their own and in containers: see probes/src/components.cpp."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator

import pytest

from course.rosenv import find_ros
from tests.underlay.rclcpp.room import Ended, Room, Started

pytestmark = pytest.mark.slow


@pytest.mark.parametrize(
    ("program", "code", "said"),
    [
        ("first", 0, "1 /space/renamed 2\n"),
        ("second", 0, "2 /space/renamed 2\n"),
        ("third", 1, "RCLCPP_COMPONENTS_REGISTER_NODE(probes::Third) is missing\n"),
    ],
)
def test_a_program_runs_its_component(program: str, code: int, said: str, room: Room) -> None:
    ended = room.run(program, "word", "--ros-args", "-r", "__ns:=/space", "-r", "__node:=renamed")
    assert ended.code == code
    assert said in ended.text


TYPES = ("probes::First", "probes::Second", "probes::Third", "probes::Staying", "probes::Failing")
NAME = "/ComponentManager"


@contextlib.contextmanager
def container(room: Room, kind: str) -> Iterator[Started]:
    """A container that `ros2 component list` knows."""
    with room.started(find_ros().python, "-m", "ros2cli", "run", "rclcpp_components", kind) as started:
        while not room.ros2("component", "list").text:
            assert started.process.poll() is None
        yield started


def load(room: Room, name: str, *options: str) -> Ended:
    return room.ros2("component", "load", NAME, "rclcpp_probes", f"probes::{name}", *options)


def test_what_a_package_registers_is_listed(room: Room) -> None:
    lines = "".join(f"{name}\n" for name in TYPES)
    assert room.ros2("component", "types", "rclcpp_probes") == Ended(0, lines)
    indented = "".join(f"  {name}\n" for name in TYPES)
    assert f"rclcpp_probes\n{indented}" in room.ros2("component", "types").text
    assert room.ros2("component", "types", "rclcpp") == Ended(0, "")
    assert room.ros2("component", "types", "nosuch") == Ended(1, "Unable to find package 'nosuch'\n")


def test_components_come_and_go(room: Room) -> None:
    with container(room, "component_container") as started:
        said = f"Loaded component 1 into '{NAME}' container node as '/staying'\n"
        assert load(room, "Staying") == Ended(0, said)
        options = ["-n", "other", "--node-namespace", "/space", "-p", "word:=hello", "-q"]
        extra = ["-e", "use_intra_process_comms:=true", "-r", "chatter:=news"]
        assert load(room, "Staying", *options, *extra) == Ended(0, "2  /space/other\n")
        listed = room.ros2("component", "list", NAME)
        assert listed == Ended(0, "1  /staying\n2  /space/other\n")
        assert room.ros2("param", "get", "/space/other", "word") == Ended(0, "String value is: hello\n")
        unload = ["component", "unload", NAME]
        gone = f"Unloaded component 1 from '{NAME}' container node\n"
        failed = (
            f"Failed to unload component 1 from '{NAME}' container node\n"
            "    No node found with unique_id: 1\n"
        )
        assert room.ros2(*unload, "1", "1") == Ended(1, gone + failed)
        assert room.ros2("component", "list") == Ended(0, f"{NAME}\n  2  /space/other\n")
        assert room.ros2("component", "list", "--containers-only") == Ended(0, f"{NAME}\n")
        text = started.end().text
        assert "/staying none 0\n" in text
        assert "/space/other hello 1\n" in text
        assert started.process.returncode == 0


@pytest.mark.parametrize(
    ("words", "complaint"),
    [
        ("rclcpp_probes probes::Nosuch", "Failed to find class with the requested plugin name."),
        ("rclcpp_probes probes::Third", "Failed to find class with the requested plugin name."),
        ("nosuch probes::First", "Could not find requested resource in ament index"),
        ("rclcpp_probes probes::Failing", "Component constructor threw an exception: not today"),
        (
            "rclcpp_probes probes::Staying -e use_intra_process_comms:=word",
            "Extra component argument 'use_intra_process_comms' must be a boolean",
        ),
    ],
)
def test_a_component_that_cannot_be_loaded(words: str, complaint: str, room: Room) -> None:
    with container(room, "component_container"):
        told = room.ros2("component", "load", NAME, *words.split())
        assert told == Ended(1, f"Failed to load component: {complaint.capitalize()}\n")
        assert room.ros2("component", "list", NAME) == Ended(0, "")


def test_a_container_that_is_not_there(room: Room) -> None:
    lost = Ended(1, "Unable to find container node '/nosuch'\n")
    assert room.ros2("component", "list", "/nosuch") == lost
    assert room.ros2("component", "load", "/nosuch", "rclcpp_probes", "probes::First") == lost
    assert room.ros2("component", "unload", "/nosuch", "1") == lost


@pytest.mark.parametrize("kind", ["component_container_mt", "component_container_isolated"])
def test_a_component_that_blocks_stops_no_other(kind: str, room: Room) -> None:
    with container(room, kind) as started:
        load(room, "Staying", "-n", "blocking", "-p", "blocks:=true")
        assert load(room, "Staying", "-q") == Ended(0, "2  /staying\n")
        assert room.ros2("param", "get", "/staying", "word") == Ended(0, "String value is: none\n")
        unloaded = room.ros2("component", "unload", "-q", NAME, "2")
        assert unloaded == Ended(0, "2\n")
        assert started.end().code == 0


def test_a_component_has_a_container_of_its_own(room: Room) -> None:
    command = [find_ros().python, "-m", "ros2cli", "component", "standalone", "rclcpp_probes"]
    with room.started(*command, "probes::Staying", "-c", "alone", "-p", "word:=hello") as started:
        started.until("/staying hello 0")
        assert room.ros2("component", "list") == Ended(0, "/alone\n  1  /staying\n")
    with room.started(*command, "probes::First") as started:  # ends all by itself
        assert "1 /component" in started.wait().text
    with room.started(*command, "probes::Nosuch") as started:
        ended = started.wait()
        assert ended.code == 0
        assert "requested plugin name., interrupting container node\n" in ended.text
