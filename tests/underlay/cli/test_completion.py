"""What the Tab key offers, with and without argcomplete, and what the shells are told."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import Any

import pytest

from course.rosenv import find_ros
from tests.underlay.cli.place import SOURCES, environment

_SHELL_FILE = SOURCES / "ros2cli/completion/ros2-argcomplete.bash"


@pytest.fixture
def known(monkeypatch: pytest.MonkeyPatch) -> None:
    """A graph with a talker."""
    from ros2cli import complete
    from ros2cli.snapshot import Endpoint, Snapshot

    chatter = Endpoint("rt/chatter", "std_msgs::msg::dds_::String_", True, "talker", "/", (0,) * 16)
    service = Endpoint("rq/addRequest", "a::srv::dds_::Add_Request_", False, "talker", "/", (0,) * 16)
    monkeypatch.setattr(complete, "graph", lambda args: Snapshot(("/talker", "/_hidden"), (chatter, service)))


@pytest.mark.parametrize(
    ("line", "wanted"),
    [
        ("ros2 to", ["topic"]),
        ("ros2 topic ec", ["echo"]),
        ("ros2 wtf h", ["hello"]),
        ("ros2 topic echo ", ["/chatter"]),
        ("ros2 topic echo /ch", ["/chatter"]),
        ("ros2 topic pub /chatter ", ["std_msgs/msg/String"]),
        ("ros2 topic pub --rate 2 /chatter std", ["std_msgs/msg/String"]),
        ("ros2 node info ", ["/talker"]),
        ("ros2 service call ", ["/add"]),
        ("ros2 service call /add ", ["a/srv/Add"]),
        ("ros2 topic echo --qos-rel", ["--qos-reliability"]),
        ("ros2 topic echo --qos-reliability re", ["reliable"]),
        ("ros2 topic echo /chatter std_msgs/msg/String ", []),
        ("ros2 topic info 'unclosed", []),
        ("ros2 pkg create p --build-type ament_c", ["ament_cmake"]),
        ("ros2 nosuch ", []),
    ],
)
def test_offers(line: str, wanted: list[str], known: None) -> None:
    from ros2cli.completion import offers
    from ros2cli.parser import ros2_parser

    assert sorted(offers(ros2_parser(), line)) == wanted


def test_all_commands_are_offered_and_options_only_when_begun() -> None:
    from ros2cli.completion import offers
    from ros2cli.parser import ros2_parser
    from ros2cli.registry import COMMANDS

    assert set(COMMANDS) <= set(offers(ros2_parser(), "ros2 "))
    assert offers(ros2_parser(), "ros2 node list -") == [
        "--all", "--count-nodes", "--no-daemon", "--spin-time", "--use-sim-time", "-a", "-c", "-s",
    ]  # fmt: skip


@pytest.mark.parametrize("has_argcomplete", [True, False])
def test_bash_completes(has_argcomplete: bool, tmp_path: Path) -> None:
    (tmp_path / "ros2").write_text(f'#!/bin/sh\nexec {find_ros().python} {_without(has_argcomplete)} "$@"\n')
    (tmp_path / "ros2").chmod(0o755)
    for line, wanted in {"ros2 top": "topic", "ros2 pkg cre": "create", "ros2 run --pre": "--prefix"}.items():
        assert _completed(line, tmp_path).split() == [wanted]


def _without(argcomplete: bool) -> str:
    if argcomplete:
        return "-m ros2cli"
    return "-c \"import sys; sys.modules['argcomplete'] = None; from ros2cli.main import main; main()\""


def _completed(line: str, folder: Path) -> str:
    script = (
        f'source "{_SHELL_FILE}"; COMP_LINE="$1"; COMP_POINT=${{#1}}; COMP_TYPE=9; '
        "_ros2_complete 2>/dev/null; "
        'printf "%s\\n" "${COMPREPLY[@]}"; complete -p ros2 >/dev/null'
    )
    variables = environment()
    variables["PATH"] = f"{folder}:{variables['PATH']}"
    done = subprocess.run(
        ["bash", "-c", script, "bash", line], env=variables,
        capture_output=True, text=True, timeout=30, check=True,
    )  # fmt: skip
    return done.stdout


def test_a_colon_breaks_words_in_bash(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    from ros2cli import completion

    class Ended(Exception):
        pass

    def end(code: int) -> Any:
        raise Ended

    answers = tmp_path / "answers"
    variables = {"COMP_LINE": "ros2 launch a:b", "COMP_POINT": "15", "_ARGCOMPLETE_COMP_WORDBREAKS": " :="}
    for name, value in {**variables, "_ARGCOMPLETE_STDOUT_FILENAME": str(answers)}.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr(completion.importlib.util, "find_spec", lambda name: None)
    monkeypatch.setattr(completion, "offers", lambda parser, line: ["a:bc"])
    monkeypatch.setattr(completion.os, "_exit", end)
    with pytest.raises(Ended):
        completion.complete(None)
    assert answers.read_text() == "bc"
