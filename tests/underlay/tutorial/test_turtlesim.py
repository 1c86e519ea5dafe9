"""The official beginner tutorials that stand on turtlesim, as their readers type them."""

from __future__ import annotations

import math
import re

import pytest

from tests.underlay.tutorial.room import Room
from tests.underlay.tutorial.terminal import Terminal, in_order

pytestmark = pytest.mark.usefixtures("built_underlay")
SPAWNED = r"Spawning turtle \[turtle1\] at x=\[5\.544444\], y=\[5\.544444\], theta=\[0\.000000\]"
TURN = "ros2 action send_goal /turtle1/rotate_absolute turtlesim/action/RotateAbsolute"
DRIVE = (
    "ros2 topic pub --once /turtle1/cmd_vel geometry_msgs/msg/Twist "
    '"{linear: {x: 2.0, y: 0.0, z: 0.0}, angular: {x: 0.0, y: 0.0, z: 1.8}}"'
)


@pytest.fixture
def simulator(at_home: Room) -> Terminal:
    """A window in which it runs, too small for its picture: the test does not read all the time."""
    terminal = at_home.terminal(rows=10)
    terminal.begin("ros2 run turtlesim turtlesim_node")
    terminal.see(SPAWNED)
    return terminal


def _call(terminal: Terminal, service: str, kind: str, request: str = "{}") -> str:
    return terminal.run(f'ros2 service call {service} {kind} "{request}"').text


def _pose(terminal: Terminal, turtle: str = "turtle1") -> dict[str, float]:
    text = terminal.run(f"ros2 topic echo --once /{turtle}/pose").text
    return {name: float(value) for name, value in re.findall(r"^(\w+): (\S+)$", text, re.MULTILINE)}


def _color(terminal: Terminal, turtle: str) -> str:
    return terminal.run(f"ros2 topic echo --once /{turtle}/color_sensor").text


def test_what_it_offers(at_home: Room, simulator: Terminal) -> None:
    terminal = at_home.terminal()
    assert terminal.run("ros2 pkg executables turtlesim").lines == [
        f"turtlesim {name}" for name in ("draw_square", "mimic", "turtle_teleop_key", "turtlesim_node")
    ]
    assert in_order(
        terminal.run("ros2 node info /turtlesim").text,
        "  Subscribers:\n",
        "    /turtle1/cmd_vel: geometry_msgs/msg/Twist\n",
        "  Publishers:\n",
        "    /turtle1/color_sensor: turtlesim/msg/Color\n",
        "    /turtle1/pose: turtlesim/msg/Pose\n",
        "  Service Servers:\n",
        "    /clear: std_srvs/srv/Empty\n",
        "    /kill: turtlesim/srv/Kill\n",
        "    /reset: std_srvs/srv/Empty\n",
        "    /spawn: turtlesim/srv/Spawn\n",
        "    /turtle1/set_pen: turtlesim/srv/SetPen\n",
        "    /turtle1/teleport_absolute: turtlesim/srv/TeleportAbsolute\n",
        "    /turtle1/teleport_relative: turtlesim/srv/TeleportRelative\n",
        "  Action Servers:\n",
        "    /turtle1/rotate_absolute: turtlesim/action/RotateAbsolute\n",
    )
    parameters = terminal.run("ros2 param list /turtlesim").text.split()
    assert parameters[:4] == ["background_b", "background_g", "background_r", "holonomic"]
    assert terminal.run("ros2 param get /turtlesim background_g").text == "Integer value is: 86\n"
    assert "Set parameter successful" in terminal.run("ros2 param set /turtlesim background_r 150")
    assert "Set parameter successful" not in terminal.run(
        "ros2 param set /turtlesim background_r 256", code=None
    )


def test_a_turtle_drives_until_a_second_has_passed(at_home: Room, simulator: Terminal) -> None:
    terminal = at_home.terminal()
    terminal.run(DRIVE)
    while _pose(terminal)["linear_velocity"]:
        pass
    pose = _pose(terminal)
    # An arc with the radius 2.0 / 1.8 m that begins in the middle, to the right.
    center = 5.544444 + 2.0 / 1.8
    assert math.hypot(pose["x"] - 5.544444, pose["y"] - center) == pytest.approx(2.0 / 1.8, abs=0.05)
    assert 1.7 < pose["theta"] < 2.0
    terminal.run(DRIVE.replace("2.0", "20.0").replace("1.8", "0.0"))
    simulator.see(r"\[WARN\].*Oh no! I hit the wall! \(Clamping from \[x=[-\d.]+, y=-[\d.]+\]\)")


def test_services(at_home: Room, simulator: Terminal) -> None:
    terminal = at_home.terminal()
    spawn = "/spawn", "turtlesim/srv/Spawn"
    assert "Spawn_Response(name='turtle2')" in _call(terminal, *spawn, "{x: 2, y: 3, theta: 0.2}")
    assert _pose(terminal, "turtle2")["x"] == pytest.approx(2)
    assert "Spawn_Response(name='')" in _call(terminal, *spawn, "{name: turtle2}")
    simulator.see(r"\[ERROR\].*A turtle named \[turtle2\] already exists")
    assert _color(terminal, "turtle2") == "r: 255\ng: 255\nb: 255\n---\n"
    _call(terminal, "/turtle2/set_pen", "turtlesim/srv/SetPen", "{r: 200, g: 10, b: 0, width: 5}")
    _call(terminal, "/turtle2/teleport_relative", "turtlesim/srv/TeleportRelative", "{linear: 1, angular: 1}")
    pose = _pose(terminal, "turtle2")
    assert (pose["x"], pose["y"]) == pytest.approx((2 + math.cos(1.2), 3 + math.sin(1.2)), abs=1e-4)
    assert _color(terminal, "turtle2") == "r: 200\ng: 10\nb: 0\n---\n"
    _call(terminal, "/turtle2/set_pen", "turtlesim/srv/SetPen", "{'off': 1}")
    place = "{x: 8, y: 8, theta: 7}"
    _call(terminal, "/turtle2/teleport_absolute", "turtlesim/srv/TeleportAbsolute", place)
    assert _pose(terminal, "turtle2")["theta"] == pytest.approx(7 - 2 * math.pi, abs=1e-4)
    assert _color(terminal, "turtle2") == "r: 255\ng: 255\nb: 255\n---\n"
    _call(terminal, "/kill", "turtlesim/srv/Kill", "{name: turtle2}")
    assert "turtle2" not in terminal.run("ros2 topic list")
    _call(terminal, "/kill", "turtlesim/srv/Kill", "{name: turtle2}")
    simulator.see(r"\[ERROR\].*Tried to kill turtle \[turtle2\], which does not exist")
    _call(terminal, "/clear", "std_srvs/srv/Empty")
    simulator.see("Clearing turtlesim")
    _call(terminal, "/reset", "std_srvs/srv/Empty")
    simulator.see("Resetting turtlesim", SPAWNED)


def test_rotations(at_home: Room, simulator: Terminal) -> None:
    terminal, second = at_home.terminal(), at_home.terminal()
    shown = terminal.run(f"{TURN} '{{theta: 1.0}}' --feedback")
    assert in_order(
        shown.text, "Goal accepted", "Feedback:\n    remaining: ", "Result:\n    delta: -0.9", "SUCCEEDED"
    )
    simulator.see("Rotation goal completed successfully")
    assert _pose(terminal)["theta"] == pytest.approx(1.0, abs=0.05)
    terminal.begin(f"{TURN} '{{theta: -1.5}}'")
    terminal.see("Goal accepted")
    second.run(f"{TURN} '{{theta: 0.8}}'")
    simulator.see("Rotation goal received before a previous goal finished. Aborting previous goal")
    assert "ABORTED" in terminal.end()
    terminal.begin(f"{TURN} '{{theta: -1.5}}'")
    terminal.see("Goal accepted")
    second.run(DRIVE)
    simulator.see("Velocity command received during rotation goal. Aborting goal")
    assert "ABORTED" in terminal.end()
    terminal.begin(f"{TURN} '{{theta: -1.5}}'")
    terminal.see("Goal accepted")
    terminal.ctrl_c(code=None)
    simulator.see("Rotation goal canceled")


def test_the_keyboard(at_home: Room, simulator: Terminal) -> None:
    keys, terminal = at_home.terminal(), at_home.terminal()
    keys.begin("ros2 run turtlesim turtle_teleop_key")
    keys.see("Use arrow keys to move the turtle", "'Q' to quit")
    terminal.run("until ros2 node list | grep -q teleop_turtle; do :; done")
    keys.press("\x1b[A")
    while _pose(terminal)["x"] < 5.6:
        keys.press("\x1b[A")
    keys.press("t")
    simulator.see("Rotation goal completed successfully")
    assert _pose(terminal)["theta"] == pytest.approx(math.pi / 4, abs=0.05)
    keys.press("q")
    keys.end(code=0)
    assert keys.is_sane()


def test_remapping_makes_a_second_keyboard(at_home: Room, simulator: Terminal) -> None:
    terminal, keys = at_home.terminal(), at_home.terminal()
    _call(terminal, "/spawn", "turtlesim/srv/Spawn", "{x: 2, y: 3, name: turtle2}")
    keys.begin("ros2 run turtlesim turtle_teleop_key --ros-args --remap turtle1/cmd_vel:=turtle2/cmd_vel")
    keys.see("'Q' to quit")
    while _pose(terminal, "turtle2")["x"] < 2.05:
        keys.press("\x1b[A")
    assert _pose(terminal)["x"] == pytest.approx(5.544444)
    keys.ctrl_c(code=None)
    assert keys.is_sane()


def test_draw_square(at_home: Room, simulator: Terminal) -> None:
    terminal = at_home.terminal()
    terminal.begin("ros2 run turtlesim draw_square")
    terminal.see(r"New goal \[7\.54444\d 5\.54444\d, 0\.000000\]", "Reached goal")
    terminal.see(r"New goal \[7\.\d+ 5\.\d+, 1\.5", "Reached goal", r"New goal \[7\.\d+ 7\.\d+, 1\.5")
    terminal.ctrl_c(code=None)


def test_mimic_in_two_simulators(at_home: Room) -> None:
    both, mimic, terminal = at_home.terminal(rows=10), at_home.terminal(), at_home.terminal()
    both.begin("ros2 launch turtlesim multisim.launch.py")
    both.see(SPAWNED, SPAWNED)
    mimic.begin(
        "ros2 run turtlesim mimic --ros-args -r input/pose:=/turtlesim1/turtle1/pose "
        "-r output/cmd_vel:=/turtlesim2/turtle1/cmd_vel"
    )
    terminal.run("until ros2 node list | grep -q turtle_mimic; do :; done")
    terminal.run(DRIVE.replace("/turtle1", "/turtlesim1/turtle1"))
    while _pose(terminal, "turtlesim2/turtle1")["theta"] < 0.5:
        pass
    mimic.ctrl_c(code=None)
    both.ctrl_c(code=None)


def test_the_terminal_shows_the_turtle_and_is_as_before(at_home: Room) -> None:
    terminal = at_home.terminal()
    terminal.begin("ros2 run turtlesim turtlesim_node")
    terminal.see("→")
    terminal.ctrl_c(code=None)
    assert terminal.is_sane()
