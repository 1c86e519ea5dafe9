"""Chapters 22 to 24: parameters and launch files."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.underlay.tutorial.room import Room
from tests.underlay.tutorial.terminal import Terminal, in_order

PACKAGE = "python_package_that_uses_parameters_and_launch_files"
NODE = "amazing_quote_configurable_publisher_node"
FALCON = "peanut_butter_falcon_quote_publisher_node"
LAUNCH_FILE = "peanut_butter_falcon_quote_publisher_launch.py"
TYPE = "package_with_interfaces/msg/AmazingQuote"
NAMES = "period philosopher_name quote start_type_description_service topic_name use_sim_time".split()
ARGUMENTS = f'''
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument("topic", default_value="amazing_quote", description="Where to publish"),
        DeclareLaunchArgument("who", description="Who said it"),
        Node(
            package="{PACKAGE}",
            executable="{NODE}",
            output="screen",
            parameters=[{{
                "topic_name": LaunchConfiguration("topic"),
                "philosopher_name": LaunchConfiguration("who"),
            }}],
        ),
    ])
'''


@pytest.fixture
def node(room: Room) -> Terminal:
    """A window in which the configurable publisher runs."""
    terminal = room.terminal()
    terminal.begin(f"ros2 run {PACKAGE} {NODE}")
    return terminal


def test_parameters(room: Room, node: Terminal) -> None:
    terminal = room.terminal()
    assert "quote: Use the force, Pikachu!\n" in _once(terminal, "/amazing_quote")
    assert terminal.run("ros2 param list").lines == [f"/{NODE}:", *(f"  {name}" for name in NAMES)]
    assert terminal.run(f"ros2 param list /{NODE}").lines == [f"  {name}" for name in NAMES]
    get = f"ros2 param get /{NODE}"
    assert terminal.run(f"{get} quote").text == "String value is: Use the force, Pikachu!\n"
    assert terminal.run(f"{get} period").text == "Double value is: 0.5\n"
    assert terminal.run(f"{get} use_sim_time").text == "Boolean value is: False\n"
    assert terminal.run(f"ros2 param describe /{NODE} period").text == (
        "Parameter name: period\n  Type: double\n  Constraints:\n"
    )
    set_ = f"ros2 param set /{NODE}"
    assert terminal.run(f"{set_} quote 'Roads? We need none.'").text == "Set parameter successful\n"
    assert "quote: Roads? We need none.\n" in _once(terminal, "/amazing_quote")
    assert terminal.run(f"{set_} quote 42").text == (
        "Setting parameter failed: Wrong parameter type, expected 'Type.STRING' got 'Type.INTEGER'\n"
    )
    assert "Setting parameter failed: " in terminal.run(f"{set_} quot Hello")
    assert terminal.run(f"{set_} quote \"'42'\"").text == "Set parameter successful\n"
    assert terminal.run(f"{get} quote").text == "String value is: 42\n"
    node.ctrl_c(code=0)


def test_dump_and_load(room: Room, node: Terminal, tmp_path: Path) -> None:
    terminal = room.terminal()
    terminal.run(f"cd {tmp_path}")
    _once(terminal, "/amazing_quote")
    dumped = terminal.run(f"ros2 param dump /{NODE}")
    assert in_order(
        dumped.text,
        f"/{NODE}:\n  ros__parameters:\n",
        "    period: 0.5\n",
        "    quote: Use the force, Pikachu!\n",
    )
    assert not terminal.run(f"ros2 param dump /{NODE} > {NODE}.yaml").text
    terminal.run(f"ros2 param set /{NODE} quote Else")
    loaded = terminal.run(f"ros2 param load /{NODE} {NODE}.yaml")
    assert in_order(loaded.text, "Set parameter period successful\n", "Set parameter quote successful\n")
    assert "Traceback" not in loaded
    assert "Pikachu" in terminal.run(f"ros2 param get /{NODE} quote")
    assert "missing.yaml" in terminal.run(f"ros2 param load /{NODE} missing.yaml", code=1)
    node.ctrl_c(code=0)
    terminal.run(f"sed -i 's/quote: Use.*/quote: From the file/' {NODE}.yaml")
    node.begin(f"ros2 run {PACKAGE} {NODE} --ros-args --params-file {tmp_path}/{NODE}.yaml")
    assert "quote: From the file\n" in _once(terminal, "/amazing_quote")
    node.ctrl_c(code=0)


def test_parameters_on_the_command_line(room: Room) -> None:
    node, terminal = room.terminal(), room.terminal()
    node.begin(
        f"ros2 run {PACKAGE} {NODE} --ros-args -p quote:='Carpe diem' -p period:=0.1 -p topic_name:=latin "
        "-r __node:=roman"
    )
    assert "quote: Carpe diem\nphilosopher_name: Uncle Ben\n" in _once(terminal, "/latin")
    assert terminal.run("ros2 param get /roman period").text == "Double value is: 0.1\n"
    terminal.begin("ros2 topic hz /latin")
    terminal.see(r"average rate: ([5-9]|10)\.\d+\r\n", "window: ")
    terminal.ctrl_c(code=2)
    node.ctrl_c(code=0)
    failed = node.run(f"ros2 run {PACKAGE} {NODE} --ros-args -p period=0.1", code=1)
    assert "Couldn't parse" in failed or "parse" in failed


def test_parameters_mistyped(room: Room, node: Terminal) -> None:
    terminal = room.terminal()
    _once(terminal, "/amazing_quote")
    for words, answer in {
        "get /amazing_node quote": "Node not found",
        "list /amazing_node": "Node not found",
        "dump /amazing_node": "Node not found",
        "set /amazing_node quote x": "Node not found",
        f"get /{NODE} quot": "",
    }.items():
        told = terminal.run(f"ros2 param {words}", code=1)
        assert answer in told and "Traceback" not in told
    assert "required: parameter_name" in terminal.run(f"ros2 param get /{NODE}", code=2)
    assert "required: value" in terminal.run(f"ros2 param set /{NODE} quote", code=2)
    node.ctrl_c(code=0)


def test_launch(room: Room) -> None:
    launch, terminal = room.terminal(), room.terminal()
    launch.begin(f"ros2 launch {PACKAGE} {LAUNCH_FILE}")
    launch.see(
        r"\[INFO\] \[launch\]: All log files can be found below ",
        r"\[INFO\] \[launch\]: Default logging verbosity is set to INFO",
        rf"\[INFO\] \[{NODE}-1\]: process started with pid \[\d+\]",
    )
    _once(terminal, "/truly_inspirational_quote")
    assert terminal.run("ros2 node list").text == f"/{FALCON}\n"
    assert terminal.run(f"ros2 param get /{FALCON} period").text == "Double value is: 0.25\n"
    terminal.begin("ros2 topic hz /truly_inspirational_quote")
    terminal.see(r"average rate: [34]\.\d+\r\n", "window: ")
    terminal.ctrl_c(code=2)
    ended = launch.ctrl_c(code=0)
    assert in_order(
        ended.text,
        "[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)\n",
        f"[INFO] [{NODE}-1]: process has finished cleanly [pid ",
    )
    assert "Traceback" not in ended and "ERROR" not in ended
    assert not terminal.run("ros2 node list").text


def test_a_window_is_closed_while_a_launch_runs(room: Room) -> None:
    launch, terminal = room.terminal(), room.terminal()
    launch.begin(f"ros2 launch {PACKAGE} {LAUNCH_FILE}")
    _once(terminal, "/truly_inspirational_quote")
    launch.close()


def test_launch_by_path_with_arguments(room: Room, tmp_path: Path) -> None:
    (tmp_path / "who_launch.py").write_text(ARGUMENTS)
    launch, terminal = room.terminal(), room.terminal()
    launch.run(f"cd {tmp_path}")
    assert launch.run("ros2 launch who_launch.py -s").text == (
        "Arguments (pass arguments as '<name>:=<value>'):\n\n"
        "    'topic':\n        Where to publish\n        (default: 'amazing_quote')\n\n"
        "    'who':\n        Who said it\n"
    )
    assert launch.run("ros2 launch ./who_launch.py -s").lines[2] == "    'topic':"
    refused = launch.run("ros2 launch who_launch.py", code=1)
    assert "missing required argument 'who'" in refused
    assert "malformed launch argument 'Ada'" in launch.run("ros2 launch who_launch.py Ada", code=1)
    launch.begin(f"ros2 launch {tmp_path}/who_launch.py who:='Ada Lovelace' topic:=notes")
    assert "philosopher_name: Ada Lovelace\n" in _once(terminal, "/notes")
    assert in_order(
        launch.ctrl_c(code=0).text, "user interrupted with ctrl-c", "process has finished cleanly"
    )


def test_launch_without_running(room: Room) -> None:
    terminal = room.terminal()
    launch = f"ros2 launch {PACKAGE} {LAUNCH_FILE}"
    assert terminal.run(f"{launch} -s").text == (
        "Arguments (pass arguments as '<name>:=<value>'):\n\n  No arguments.\n"
    )
    assert terminal.run(f"{launch} --show-args") == terminal.run(f"{launch} -s")
    printed = terminal.run(f"{launch} -p")
    assert in_order(printed.text, "LaunchDescription", "└── ExecuteProcess(cmd=[ExecInPkg(", NODE)


def test_launch_with_more_to_read(room: Room) -> None:
    terminal, other = room.terminal(), room.terminal()
    terminal.begin(f"ros2 launch {PACKAGE} {LAUNCH_FILE} -d")
    terminal.see(r"\[DEBUG\] \[launch", "process started with pid")
    _once(other, "/truly_inspirational_quote")
    assert in_order(
        terminal.ctrl_c(code=0).text, "user interrupted with ctrl-c", "process has finished cleanly"
    )


def test_launch_mistyped(room: Room, tmp_path: Path) -> None:
    terminal = room.terminal()
    terminal.run(f"cd {tmp_path}")
    (tmp_path / "broken_launch.py").write_text("def generate_launch_description(:\n    pass\n")
    (tmp_path / "empty_launch.py").write_text("\n")
    for words, answer in {
        f"{PACKAGE} peanut_launch.py": "file 'peanut_launch.py' was not found in the share directory",
        f"{PACKAGE}s {LAUNCH_FILE}": f"Package '{PACKAGE}s' not found",
        "./peanut_launch.py": "",
        "broken_launch.py": "invalid syntax",
        "empty_launch.py": "generate_launch_description",
    }.items():
        told = terminal.run(f"ros2 launch {words}", code=1)
        assert answer in told and "Traceback" not in told
    terminal.run("ros2 launch", code=2)


def _once(terminal: Terminal, topic: str) -> str:
    """One message, of a topic that may not be there yet."""
    return terminal.run(f"ros2 topic echo --once {topic} {TYPE}").text
