"""Chapters 12 to 15: nodes of one's own, a library, and Ctrl+C."""

from __future__ import annotations

from pathlib import Path

import psutil

from tests.underlay.tutorial.room import Room
from tests.underlay.tutorial.terminal import in_order

NODES = "python_package_with_a_node"
USER = "python_package_that_uses_the_library"


def test_a_node_that_prints_forever(room: Room) -> None:
    terminal, other = room.terminal(), room.terminal()
    terminal.begin(f"ros2 run {NODES} print_forever_node")
    printed = terminal.see(r"Printed 0 times\.", r"Printed 1 times\.", r"Printed 2 times\.")
    assert in_order(printed, "[INFO] [", "] [print_forever]: Printed 0 times.\n")
    assert other.run("ros2 node list").text == "/print_forever\n"
    assert "Traceback" not in terminal.ctrl_c(code=0)
    assert not other.run("ros2 node list").text
    assert terminal.run(f"ros2 run {NODES} sample_python_node").text == f"Hi from {NODES}.\n"


def test_two_nodes_of_one_package(room: Room) -> None:
    first, second, other = room.terminal(), room.terminal(), room.terminal()
    first.begin(f"ros2 run {NODES} print_forever_node")
    second.begin(f"ros2 run {NODES} print_forever_node --ros-args -r __node:=print_again -r __ns:=/night")
    first.see("print_forever.*Printed 1")
    second.see(r"\[night\.print_again\]: Printed 1")
    assert other.run("ros2 node list").text == "/night/print_again\n/print_forever\n"
    assert other.run("ros2 node list --count-nodes").text == "2\n"
    info = other.run("ros2 node info /night/print_again")
    assert in_order(
        info.text,
        "/night/print_again\n",
        "  Subscribers:",
        "  Publishers:",
        "/rosout: rcl_interfaces/msg/Log",
    )
    assert "Unable to find node '/print_once'" in other.run("ros2 node info /print_once", code=1)
    first.ctrl_c(code=0)
    second.ctrl_c(code=0)


def test_ctrl_z_then_fg(room: Room) -> None:
    terminal = room.terminal()
    terminal.begin(f"ros2 run {NODES} print_forever_node")
    terminal.see("Printed 1 times")
    terminal.press("\x1a")
    assert "Stopped" in terminal.end(code=148)
    room.await_status("print_forever_node", psutil.STATUS_STOPPED)
    terminal.begin("fg")
    terminal.see("Printed 3 times")
    assert "Traceback" not in terminal.ctrl_c(code=0)


def test_a_window_is_closed_while_a_node_runs(room: Room) -> None:
    """The room's end tells whether the node went with it."""
    terminal, other = room.terminal(), room.terminal()
    terminal.begin(f"ros2 run {NODES} print_forever_node")
    terminal.see("Printed 0 times")
    terminal.close()
    psutil.wait_procs(room.running("print_forever_node"), 10)
    assert not other.run("ros2 node list").text


def test_output_goes_where_it_is_sent(room: Room, tmp_path: Path) -> None:
    """A node's log goes to standard error, its print to standard output."""
    terminal = room.terminal()
    terminal.begin(f"ros2 run {NODES} print_forever_node 2>&1 | grep --line-buffered times")
    terminal.see("Printed 0 times", "Printed 1 times")
    terminal.ctrl_c(code=130)  # grep's
    assert not terminal.run(f"ros2 run {NODES} sample_python_node > {tmp_path}/said.txt").text
    assert terminal.run(f"cat {tmp_path}/said.txt").text == f"Hi from {NODES}.\n"


def test_a_library(room: Room) -> None:
    terminal = room.terminal()
    code = (
        "from python_package_with_a_library.sample_python_library import *; "
        "print(SampleClass('Ada').get_name(), sample_function_for_square_of_sum(1, 2))"
    )
    assert terminal.run(f'python3 -c "{code}"').text == "Ada 9\n"


def test_a_node_that_uses_the_library(room: Room) -> None:
    terminal = room.terminal()
    terminal.begin(f"ros2 run {USER} node_that_uses_the_library")
    terminal.see(r"sample_function_for_square_of_sum\([\d.]+, ?[\d.]+\) returned [\d.]+")
    terminal.see(r"sample_class_with_random_name.get_name\(\) returned \w{10}")
    assert "Traceback" not in terminal.ctrl_c(code=0)
