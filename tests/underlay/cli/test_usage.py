"""Help, usage errors and what is not offered: no node is needed, and no rclpy."""

from __future__ import annotations

import subprocess
from dataclasses import replace

import pytest

from course.rosenv import find_ros
from tests.underlay.cli.captured import case
from tests.underlay.cli.place import environment, ros2

# The real one lists no command of a package that is not installed; here they are answered.
_ALSO = ("'bag', ", "'control', ", "'security', ")


@pytest.mark.parametrize(
    "name",
    [
        "node_noverb", "topic_noverb", "daemon_noverb", "node_unknown_verb", "param_unknown_verb",
        "topic_unknown_verb", "param_get_missing_arg", "topic_echo_missing_arg", "service_find_nodaemon",
        "service_type_nodaemon",
    ],
)  # fmt: skip
def test_says_what_the_real_command_says(name: str) -> None:
    real = case(name)
    assert ros2(*real.arguments) == real.expected


def test_help_of_the_whole_command() -> None:
    real = case("ros2_tty").expected
    assert ros2().stdout == real.stdout.replace("\r\n", "\n")
    assert ros2("-h").stdout == real.stdout.replace("\r\n", "\n")


def test_unknown_command() -> None:
    outcome = ros2("nosuch")
    for name in _ALSO:
        assert name in outcome.stderr
        outcome = replace(outcome, stderr=outcome.stderr.replace(name, ""))
    assert outcome == case("ros2_unknown_command").expected


@pytest.mark.parametrize("command", ["bag", "control", "security"])
@pytest.mark.parametrize("rest", [[], ["-h"], ["record", "-a"]])
def test_what_is_not_offered_says_so_in_one_line(command: str, rest: list[str]) -> None:
    outcome = ros2(command, *rest)
    assert (outcome.code, outcome.stdout) == (1, "")
    assert outcome.stderr.count("\n") == 1
    assert "sudo apt install ros-jazzy-" in outcome.stderr


def test_help_loads_no_rclpy() -> None:
    script = (
        "import sys\nfrom ros2cli.main import main\n"
        "try:\n    main(['topic', 'echo', '-h'])\nexcept SystemExit:\n    pass\n"
        "print([name for name in sys.modules if name.startswith(('rclpy', 'yaml', 'numpy'))])"
    )
    command = [str(find_ros().python), "-c", script]
    done = subprocess.run(command, env=environment(), capture_output=True, text=True, timeout=60, check=True)
    assert done.stdout.endswith("\n[]\n")


@pytest.mark.parametrize("verb", ["topic pub", "topic echo", "service call", "action send_goal", "param set"])
def test_help_has_examples_that_can_be_typed(verb: str) -> None:
    from ros2cli.examples import EXAMPLES
    from ros2cli.parser import ros2_parser

    outcome = ros2(*verb.split(), "-h")
    assert outcome.code == 0
    for line in EXAMPLES[verb]:
        assert f"\n  {line}\n" in outcome.stdout
    assert ros2_parser()


def test_examples_parse() -> None:
    import shlex

    from ros2cli.examples import EXAMPLES
    from ros2cli.parser import ros2_parser

    for line in (line for lines in EXAMPLES.values() for line in lines):
        words = shlex.split(line)
        assert words[0] == "ros2"
        assert ros2_parser().parse_args(words[1:]).main
