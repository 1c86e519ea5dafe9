"""Help, usage errors and what is not offered: no node is needed, and no rclpy."""

from __future__ import annotations

import subprocess

import pytest

from course.rosenv import find_ros
from tests.underlay.cli.place import captured, environment, ros2

# The real one lists no command of a package that is not installed; here they are answered.
_ALSO = ("'bag', ", "'security', ")


@pytest.mark.parametrize(
    "name",
    [
        "node_noverb", "topic_noverb", "daemon_noverb", "node_unknown_verb", "param_unknown_verb",
        "topic_unknown_verb", "param_get_missing_arg", "topic_echo_missing_arg", "service_find_nodaemon",
        "service_type_nodaemon",
    ],
)  # fmt: skip
def test_says_what_the_real_command_says(name: str) -> None:
    arguments, expected = captured(name)
    assert ros2(*arguments) == expected


def test_help_of_the_whole_command() -> None:
    _, expected = captured("ros2_tty")
    assert ros2().stdout == expected.stdout
    assert ros2("-h").stdout == expected.stdout


def test_unknown_command() -> None:
    _, expected = captured("ros2_unknown_command")
    outcome = ros2("nosuch")
    for name in _ALSO:
        assert name in outcome.stderr
        outcome = type(outcome)(outcome.code, outcome.stdout, outcome.stderr.replace(name, ""))
    assert outcome == expected


@pytest.mark.parametrize("command", ["bag", "component", "lifecycle", "multicast", "security"])
@pytest.mark.parametrize("rest", [[], ["-h"], ["record", "-a"]])
def test_what_is_not_offered_says_so_in_one_line(command: str, rest: list[str]) -> None:
    outcome = ros2(command, *rest)
    assert (outcome.code, outcome.stdout) == (1, "")
    assert outcome.stderr.count("\n") == 1
    assert "sudo apt install ros-jazzy-" in outcome.stderr


def test_help_and_completion_load_no_rclpy() -> None:
    script = (
        "import sys\nfrom ros2cli.main import main\n"
        "try:\n    main(['topic', 'echo', '-h'])\nexcept SystemExit:\n    pass\n"
        "print([name for name in sys.modules if name.startswith(('rclpy', 'yaml', 'numpy'))])"
    )
    command = [str(find_ros().python), "-c", script]
    done = subprocess.run(command, env=environment(), capture_output=True, text=True, timeout=60, check=True)
    assert done.stdout.endswith("\n[]\n")


def test_completion_offers_verbs() -> None:
    line = "ros2 topic ec"
    variables = {
        **environment(), "_ARGCOMPLETE": "1", "COMP_LINE": line, "COMP_POINT": str(len(line)),
        "_ARGCOMPLETE_STDOUT_FILENAME": "/dev/stdout", "_ARGCOMPLETE_IFS": " ",
    }  # fmt: skip
    command = [str(find_ros().python), "-m", "ros2cli"]
    done = subprocess.run(command, env=variables, capture_output=True, text=True, timeout=60, check=False)
    assert done.stdout.split() == ["echo"]
