"""What is logged, and in which form."""

from __future__ import annotations

import re

import pytest

from tests.underlay.rclcpp.room import Room

pytestmark = pytest.mark.slow
SAID = [
    "INFO logger info two 2.0", "WARN logger warn 3!", "ERROR other error 100%", "FATAL logger.child fatal",
]  # fmt: skip
TIMES = {
    "once": [0], "stream once": [0], "skipfirst": [1, 2], "stream skipfirst": [1, 2], "expression": [1],
    "stream expression": [1], "function": [], "stream function": [0, 1, 2], "throttle": [0],
    "stream throttle": [0], "skipfirst throttle": [], "stream skipfirst throttle": [],
    "unthrottled": [0, 1, 2], "simulated": [1, 2], "simulated skipfirst": [2],
}  # fmt: skip
FORM = {"RCUTILS_CONSOLE_OUTPUT_FORMAT": "{severity} {name} {message}"}


def test_every_macro_logs_when_it_should(room: Room) -> None:
    said = room.run("logging", **FORM).text.splitlines()
    assert said[:4] == SAID
    assert said[-1] == "INFO logger after"
    for kind, expected in TIMES.items():
        prefix = f"INFO logger {kind} "
        found = [line.removeprefix(prefix) for line in said if re.fullmatch(f"{prefix}\\d", line)]
        assert found == [str(number) for number in expected], kind


def test_the_form_is_that_of_rclpy(room: Room) -> None:
    time = re.compile(r"\[\d{10}\.\d{9}\]")
    with room.peer("log") as peer:
        theirs = time.sub("[time]", peer.wait().text).splitlines()
    ours = time.sub("[time]", room.run("logging").text).splitlines()
    assert theirs[0] == "[INFO] [time] [logger]: info two 2.0"
    assert theirs[0] in ours
    assert theirs[1].replace("[logger]", "[other]") in ours


@pytest.mark.parametrize(("level", "first"), [("debug", "DEBUG logger debug 1"), ("warn", SAID[1])])
def test_the_level_is_set_from_the_command_line(level: str, first: str, room: Room) -> None:
    said = room.run("logging", "--ros-args", "--log-level", f"logger:={level}", **FORM).text
    assert next(line for line in said.splitlines() if " logger " in line) == first


def test_others_are_told_on_rosout(room: Room) -> None:
    with room.peer("rosout") as peer:
        peer.until("listening")
        with room.program("logging", "stay"):
            heard = peer.until("unthrottled 2")
    assert "20 logger info two 2.0 main True\n" in heard
    assert "50 logger.child fatal main True\n" in heard


def test_the_level_is_set_by_a_service(room: Room) -> None:
    with room.program("further", "levels") as node:
        node.until("ready")
        level = "{levels: [{name: levels, level: 10}]}"
        room.ros2("service", "call", "/levels/set_logger_levels", "rcl_interfaces/srv/SetLoggerLevels", level)
        assert "[DEBUG]" in node.until("now heard")
