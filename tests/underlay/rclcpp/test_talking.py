"""Topics: our rclcpp on one side, rclpy on the other."""

from __future__ import annotations

import pytest

from tests.underlay.rclcpp.room import Room

pytestmark = pytest.mark.slow
FORMS = (
    "reference", "generic", "value", "shared", "shared_const", "const_reference", "unique", "info",
    "unique_info", "function", "bound", "bound_reference", "bound_info",
)  # fmt: skip


def test_rclpy_hears_all_that_is_published_in_order(room: Room) -> None:
    with room.peer("hear", "/chatter", "transient_local") as peer, room.program("talking", "say", "20"):
        heard = peer.until("19\n").splitlines()
    assert heard == ["listening", *map(str, range(20))]


def test_callbacks_of_all_forms_hear_rclpy(room: Room) -> None:
    with room.program("talking", "hear") as hearer, room.peer("say", "/chatter", "Grüße"):
        for form in FORMS:  # it is said again and again
            hearer.until(f"[hearer]: heard Grüße by {form}\n")


def test_names_are_remapped_from_the_command_line(room: Room) -> None:
    remapping = ("--ros-args", "-r", "__ns:=/space", "-r", "__node:=renamed", "-r", "chatter:=news")
    with (
        room.program("talking", "hear", *remapping) as hearer,
        room.peer("say", "/space/news", "hello"),
    ):
        hearer.until("[space.renamed]: heard hello by reference\n")
        assert "/space/renamed\n" in room.ros2("node", "list", "--no-daemon").text


def test_what_is_kept_reaches_those_who_come_late(room: Room) -> None:
    with room.program("talking", "late") as sayer:
        sayer.until("published")
        with room.peer("hear", "/chatter", "transient_local") as peer:
            peer.until("kept")


def test_incompatible_qos_is_warned_of(room: Room) -> None:
    with room.program("talking", "quiet") as sayer:
        with room.peer("hear", "/chatter"):
            said = sayer.until("incompatible QoS")
        with room.program("talking", "hear") as hearer:
            heard = hearer.until("incompatible QoS")
    assert (
        "[sayer]: New subscription discovered on topic '/chatter', requesting incompatible QoS. "
        "No messages will be sent to it. Last incompatible policy: RELIABILITY_QOS_POLICY" in said
    )
    assert (
        "[hearer]: New publisher discovered on topic '/chatter', offering incompatible QoS. "
        "No messages will be sent to it. Last incompatible policy: RELIABILITY_QOS_POLICY" in heard
    )
