"""The learner's shell: what new windows know, and the Tab key."""

from __future__ import annotations

from pathlib import Path

from course.rosenv import find_ros, setup_script
from tests.underlay.tutorial.learner import LAMPS, WORKSPACE, create
from tests.underlay.tutorial.room import Room
from tests.underlay.tutorial.terminal import Terminal

NODES = "python_package_with_a_node"


def test_both_lines_in_bashrc(at_home: Room) -> None:
    """The lines that the tutorial has its readers put at the end of ~/.bashrc: ROS, and the workspace."""
    first = at_home.terminal()
    create(first, LAMPS)
    first.run("colcon build")
    first.run(f"echo 'source {setup_script(find_ros())}' >> ~/.bashrc")
    first.run(f"echo 'source ~/{WORKSPACE}/install/setup.bash' >> ~/.bashrc")
    first.run("ros2 run lamps lamp", code=1)
    second = at_home.terminal()
    assert second.run("ros2 run lamps lamp").text == "Hi from lamps.\n"
    _paths_are_named_once(second)
    second.run("source ~/.bashrc")
    _paths_are_named_once(second)
    first.run("source ~/.bashrc")
    assert first.run("ros2 run lamps lamp").text == "Hi from lamps.\n"


def _paths_are_named_once(terminal: Terminal) -> None:
    for name in ("AMENT_PREFIX_PATH", "PATH", "PYTHONPATH", "LD_LIBRARY_PATH"):
        paths = terminal.run(f"echo ${name}").text.strip().split(":")
        assert len(paths) == len(set(paths)), name


def test_all_windows_are_alike(at_home: Room) -> None:
    """So they share one daemon; and a shell in a shell changes nothing."""
    first, second = at_home.terminal(), at_home.terminal()
    variables = first.run("env | sort").lines
    assert second.run("env | sort").lines == variables
    assert set(first.run("ros2course shell -c env").lines) - set(variables) <= {"SHLVL=2", "_=/usr/bin/env"}
    assert first.run("ros2 daemon start").text == "The daemon has been started\n"
    assert second.run("ros2 daemon status").text == "The daemon is running\n"


def test_the_workspace_alone_brings_its_ros_along(room: Room) -> None:
    """In a bash that knows nothing of ROS."""
    terminal = room.terminal()
    clean = "env -i HOME=$HOME TERM=$TERM PATH=/usr/bin:/bin bash --norc"
    script = f". ~/{WORKSPACE}/install/setup.bash; ros2 run {NODES} sample_python_node"
    assert terminal.run(f"{clean} -c '{script}'").text == f"Hi from {NODES}.\n"


def test_a_home_whose_workspace_was_never_built(at_home: Room) -> None:
    bashrc = Path(at_home.home, ".bashrc")
    bashrc.write_text(f"{bashrc.read_text()}\nsource ~/{WORKSPACE}/install/setup.bash\n")
    terminal = at_home.terminal()
    assert "/rosout" in terminal.run("ros2 topic list")


def test_tab(room: Room) -> None:
    terminal = room.terminal()
    for typed, completed in {
        "ros2 to\t": "ros2 topic ",
        "ros2 topic ec\t": "ros2 topic echo ",
        "ros2 ru\tpython_package_with_a_n\tsam\t": f"ros2 run {NODES} sample_python_node ",
        "ros2 interface show package_with_interfaces/m\t": (
            "ros2 interface show package_with_interfaces/msg/AmazingQuote "
        ),
        "ros2 pkg create lamps --build-type ament_p\t": "ros2 pkg create lamps --build-type ament_python ",
        "ros2 topic echo --onc\t/ros\t": "ros2 topic echo --once /rosout ",
        f"ros2 launch /{'nowhere'}\t": "ros2 launch /nowhere",
    }.items():
        assert terminal.line_after(typed) == completed


def test_tab_twice_lists_what_there_is(room: Room) -> None:
    node, terminal = room.terminal(), room.terminal()
    node.begin(f"ros2 run {NODES} print_forever_node")
    node.see("Printed 0 times")
    assert {"print_forever_node", "sample_python_node"} <= _offered(terminal, f"ros2 run {NODES} ")
    assert {"bw", "echo", "hz", "info", "list", "pub"} <= _offered(terminal, "ros2 topic ")
    assert {"msg", "srv"} <= {
        offer.split("/")[1] for offer in _offered(terminal, "ros2 interface show package_with_interfaces/")
    }
    assert {"/parameter_events", "/rosout"} <= _offered(terminal, "ros2 topic echo /")
    assert terminal.line_after("ros2 node info /print_f\t") == "ros2 node info /print_forever "
    assert terminal.line_after("ros2 param list /print_f\t") == "ros2 param list /print_forever "
    node.ctrl_c(code=0)


def _offered(terminal: Terminal, typed: str) -> set[str]:
    return set(terminal.listed_after(f"{typed}\t\t").split())
