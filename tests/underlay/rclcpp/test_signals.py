"""What a signal ends, and how."""

from __future__ import annotations

import signal

import pytest

from tests.underlay.rclcpp.room import Room

pytestmark = pytest.mark.slow


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize("what", ["spin", "loop"])
def test_it_ends_spinning(what: str, number: signal.Signals, room: Room) -> None:
    with room.program("signals", what) as program:
        program.until("ready")
        ended = program.end(number)
    assert ended.code == 0
    assert f"[rclcpp]: signal_handler(signum={number.value})\n" in ended.text
    assert ended.text.endswith("left\n")


def test_without_handlers_it_is_the_program_that_is_told(room: Room) -> None:
    with room.program("signals", "own") as program:
        program.until("ready")
        ended = program.end()
    assert (ended.code, ended.text) == (0, "still ok\n")


def test_it_ends_sleeping(room: Room) -> None:
    with room.program("signals", "sleep") as program:
        program.until("ready")
        ended = program.end()
    assert ended.code == 0
    assert ended.text.endswith("woken\n")


def test_it_calls_what_is_to_be_called_on_shutdown(room: Room) -> None:
    with room.program("signals", "callbacks") as program:
        program.until("ready")
        ended = program.end()
    assert ended.code == 0
    assert "on shutdown\n" in ended.text
    assert "left\n" in ended.text


def test_what_fails_while_it_shuts_down_is_said(room: Room) -> None:
    with room.program("signals", "failing") as program:
        program.until("ready")
        ended = program.end()
    assert ended.code == 0
    assert "[rclcpp]: while shutting down: on purpose\n" in ended.text
    assert "left\n" in ended.text  # meanwhile: it is another thread


def test_a_callback_of_a_shutdown_may_ask_for_a_shutdown(room: Room) -> None:
    ended = room.run("signals", "nested")
    assert ended.code == 0
    assert ended.text.endswith("left\n")


def test_a_program_may_end_without_a_shutdown(room: Room) -> None:
    ended = room.run("signals", "throw")
    assert (ended.code, ended.text) == (5, "from a callback\n")
