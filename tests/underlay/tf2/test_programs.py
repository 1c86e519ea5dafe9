"""The programs of tf2_ros: what they print, and what others hear of them."""

from __future__ import annotations

import pytest

from course.rosenv import find_ros
from tests.underlay.rclcpp.room import Room

pytestmark = pytest.mark.slow

QUARTER = ("--x", "1", "--z", "0.5", "--yaw", "1.5707963267948966")
FRAMES = ("--frame-id", "world", "--child-frame-id", "robot")
PUBLISHER, ECHO = "static_transform_publisher", "tf2_echo"


def run_words(name: str, *words: str) -> list[str]:
    return [str(find_ros().python), "-m", "ros2cli", "run", "tf2_ros", name, *words]


def said(room: Room, name: str, *words: str) -> tuple[int, str]:
    """How a program ends, and what it says."""
    with room.started(*run_words(name, *words)) as started:
        ended = started.wait()
    return ended.code, ended.text


def test_a_static_frame_is_told(room: Room) -> None:
    with room.started(*run_words(PUBLISHER, *QUARTER, *FRAMES)) as publisher:
        start = publisher.until("from 'world' to 'robot'")
        assert "[static_transform_publisher_" in start
        assert start.endswith(
            "Spinning until stopped - publishing transform\n"
            "translation: ('1.000000', '0.000000', '0.500000')\n"
            "rotation: ('0.000000', '0.000000', '0.707107', '0.707107')\n"
            "from 'world' to 'robot'\n"
        )
        with room.started(*run_words(ECHO, "world", "robot", "10")) as echo:
            shown = echo.until("- Matrix:") + echo.until("  0.000  0.000  0.000  1.000")
            shown = shown[shown.index("At time") :]
            assert shown == (
                "At time 0.0\n"
                "- Translation: [1.000, 0.000, 0.500]\n"
                "- Rotation: in Quaternion [0.000, 0.000, 0.707, 0.707]\n"
                "- Rotation: in RPY (radian) [0.000, -0.000, 1.571]\n"
                "- Rotation: in RPY (degree) [0.000, -0.000, 90.000]\n"
                "- Matrix:\n"
                "  0.000 -1.000  0.000  1.000\n"
                "  1.000  0.000  0.000  0.000\n"
                "  0.000  0.000  1.000  0.500\n"
                "  0.000  0.000  0.000  1.000\n"
            )
        heard = room.ros2("topic", "echo", "--once", "/tf_static").text
        assert "    frame_id: world\n  child_frame_id: robot\n" in heard


def test_the_older_order_of_arguments_still_works(room: Room) -> None:
    words = ("1", "2", "3", "0", "0", "0", "1", "world", "robot")
    with room.started(*run_words(PUBLISHER, *words)) as publisher:
        text = publisher.until("from 'world' to 'robot'")
    assert "Old-style arguments are deprecated; see --help for new-style arguments" in text
    assert "translation: ('1.000000', '2.000000', '3.000000')" in text


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        ((), "Frame id must not be empty"),
        (("--frame-id", "world"), "Child frame id must not be empty"),
        (("--x", "far", *FRAMES), "Failed to parse --x argument as float"),
        ((*FRAMES, "--x"), "Not enough arguments for --x"),
        (("--qw", "1", "--yaw", "0", *FRAMES), "Cannot specify both quaternion and Euler rotations"),
        (("word", *FRAMES), "Extra unparsed arguments on command-line"),
    ],
)
def test_what_is_wrong_is_said_with_the_usage(words: tuple[str, ...], reason: str, room: Room) -> None:
    code, text = said(room, PUBLISHER, *words)
    assert code == 1
    said_first = f"error parsing command line arguments: {reason}\n"
    assert f"{said_first}usage: static_transform_publisher [--x X]" in text


def test_the_echo_waits_until_a_frame_is_known(room: Room) -> None:
    with room.started(*run_words(ECHO, "world", "robot")) as echo:
        text = echo.until("Waiting for transform")
    assert (
        'Waiting for transform world ->  robot: Invalid frame ID "world" passed to canTransform argument '
        "target_frame - frame does not exist\n" in text
    )


def test_the_echo_knows_its_arguments(room: Room) -> None:
    code, text = said(room, ECHO)
    assert code == 1 and text.startswith("Usage: tf2_echo source_frame target_frame [echo_rate]\n")
    failed = "Failed to convert rate argument '{}' to a floating-point number"
    code, text = said(room, ECHO, "world", "robot", "often")
    assert code == 2 and failed.format("often") in text
    code, text = said(room, ECHO, "world", "robot", "1.0often")
    assert code == 3 and failed.format("1.0often") in text
