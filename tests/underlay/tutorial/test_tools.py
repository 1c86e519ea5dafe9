"""The rest of `ros2`: doctor, daemon, actions, demo nodes, and help for those who are lost."""

from __future__ import annotations

from pathlib import Path

from tests.underlay.tutorial.room import Room
from tests.underlay.tutorial.terminal import in_order

FIBONACCI = "example_interfaces/action/Fibonacci"
SERVER = Path(__file__).with_name("fibonacci_server.py")


def test_help(at_home: Room) -> None:
    terminal = at_home.terminal(columns=80)
    first = terminal.run("ros2")
    assert in_order(
        first.text, "usage: ros2 [-h]", "Commands:\n", "  action ", "  interface ", "  topic ", "  wtf "
    )
    assert terminal.run("ros2 -h") == first == terminal.run("ros2 --help")
    for command in ("action", "daemon", "interface", "node", "param", "pkg", "service", "topic"):
        told = terminal.run(f"ros2 {command}")
        assert in_order(told.text, f"usage: ros2 {command} [-h]", "Commands:\n")
        assert all(len(line) <= 80 for line in told.lines)
    assert in_order(terminal.run("ros2 topic pub -h").text, "usage: ros2 topic pub", "-r N", "--once")
    assert "invalid choice: 'topics'" in terminal.run("ros2 topics", code=2)
    assert "sudo apt install ros-jazzy-ros2bag" in terminal.run("ros2 bag record -a", code=1)
    assert terminal.run("ros2 -h | head -n 2").lines == first.lines[:2]


def test_doctor(at_home: Room) -> None:
    terminal = at_home.terminal()
    checked = terminal.run("ros2 doctor")
    assert "All 3 checks passed\n" in checked
    assert "All 3 checks passed\n" in terminal.run("ros2 wtf")
    assert in_order(
        terminal.run("ros2 doctor --report").text, "NETWORK CONFIGURATION", "ROS 2 INFORMATION", "jazzy"
    )


def test_daemon(at_home: Room) -> None:
    terminal = at_home.terminal()
    daemon = "ros2 daemon"
    for words, said in (
        ("status", "The daemon is not running"),
        ("stop", "The daemon is not running"),
        ("start", "The daemon has been started"),
        ("start", "The daemon is already running"),
        ("status", "The daemon is running"),
        ("stop", "The daemon has been stopped"),
        ("status", "The daemon is not running"),
    ):
        assert terminal.run(f"{daemon} {words}").text == f"{said}\n"
    assert terminal.run("ros2 topic list").text == "/parameter_events\n/rosout\n"
    assert terminal.run("ros2 topic list --no-daemon").text == "/parameter_events\n/rosout\n"


def test_the_daemon_does_not_end_with_the_window(at_home: Room) -> None:
    """Nor does Ctrl+C in the window that started it."""
    first, second = at_home.terminal(), at_home.terminal()
    first.run("ros2 daemon start")
    first.begin("ros2 topic echo /nothing std_msgs/msg/String; echo over")
    at_home.await_program("echo")
    first.ctrl_c(code=None)
    first.leave()
    assert second.run("ros2 daemon status").text == "The daemon is running\n"


def test_actions(built_underlay: None, at_home: Room) -> None:
    server, terminal = at_home.terminal(), at_home.terminal()
    server.begin(f"python3 {SERVER}")
    goal = f"ros2 action send_goal /fibonacci {FIBONACCI} '{{order: 4}}'"
    assert in_order(
        terminal.run(f"{goal} --feedback").text,
        "Waiting for an action server to become available...\n",
        "Sending goal:\n     order: 4\n",
        "Goal accepted with ID: ",
        "Feedback:\n    sequence:\n- 0\n- 1\n- 1\n",
        "Result:\n    sequence:\n- 0\n- 1\n- 1\n- 2\n- 3\n",
        "Goal finished with status: SUCCEEDED\n",
    )
    assert "Feedback" not in terminal.run(goal)
    assert terminal.run("ros2 action list").text == "/fibonacci\n"
    assert terminal.run("ros2 action list -t").text == f"/fibonacci [{FIBONACCI}]\n"
    assert terminal.run("ros2 action type /fibonacci").text == f"{FIBONACCI}\n"
    assert terminal.run("ros2 action info /fibonacci").text == (
        "Action: /fibonacci\nAction clients: 0\nAction servers: 1\n    /fibonacci_server\n"
    )
    assert in_order(
        terminal.run("ros2 node info /fibonacci_server").text,
        "  Action Servers:\n    /fibonacci: ",
        FIBONACCI,
    )
    server.ctrl_c(code=0)


def test_an_action_that_nobody_offers(built_underlay: None, at_home: Room) -> None:
    terminal = at_home.terminal()
    terminal.begin(f"ros2 action send_goal /fibonacci {FIBONACCI} '{{order: 4}}'")
    terminal.see("Waiting for an action server to become available")
    assert terminal.ctrl_c(code=2).ends_at_ctrl_c


def test_demo_nodes(at_home: Room) -> None:
    talker, listener, terminal = at_home.terminal(), at_home.terminal(), at_home.terminal()
    listener.begin("ros2 run demo_nodes_py listener")
    talker.begin("ros2 run demo_nodes_py talker")
    talker.see(r"\[talker\]: Publishing: .Hello World: \d")
    listener.see(r"\[listener\]: I heard: .Hello World: \d")
    assert terminal.run("ros2 topic type /chatter").text == "std_msgs/msg/String\n"
    for one in (talker, listener):
        assert "Traceback" not in one.ctrl_c(code=0)


def test_ctrl_c_while_a_command_is_still_loading(at_home: Room) -> None:
    """Whatever it has come to, nothing is left of it, and what is typed next is heard."""
    terminal = at_home.terminal()
    for _ in range(3):
        terminal.begin("ros2 topic echo /nothing std_msgs/msg/String")
        at_home.await_program("echo")
        ended = terminal.ctrl_c(code=None)
        assert ended.code in (1, 2, 130)  # 1: Python itself was still loading
    assert not at_home.running("echo")
    assert terminal.run("ros2 topic list").text == "/parameter_events\n/rosout\n"


def test_a_command_in_the_background(at_home: Room) -> None:
    terminal = at_home.terminal()
    terminal.run("ros2 topic pub -r 20 /news std_msgs/msg/String '{data: Hello}' > /dev/null &")
    assert terminal.run("ros2 topic echo --once /news std_msgs/msg/String").text == "data: Hello\n---\n"
    terminal.begin("fg")
    assert terminal.ctrl_c(code=2).ends_at_ctrl_c
    assert not at_home.running("pub")
