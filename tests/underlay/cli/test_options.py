"""Every argument and option that the real commands have, and that they may stand in any order."""

from __future__ import annotations

import argparse
import itertools
import re
from pathlib import Path
from typing import Any

import pytest

_ROW = re.compile(r"^\| `ros2 ?([\w ]*)` \| (.*?) \| (.*?) \| (.*?) \| (.*?) \|$")
# What the table took out of sentences of the real help, or cut off at an underscore or the end of a line.
_NO_OPTIONS = {"--wait-", "--package", "--args", "-e", "-u"}


def _rows() -> dict[str, tuple[list[str], list[str], set[str]]]:
    """Arguments, sub-commands and options of each command."""
    rows = {}
    for line in Path(__file__).with_name("options.md").read_text(encoding="utf-8").splitlines():
        if match := _ROW.match(line):
            name, arguments, verbs, short, long = (
                part.split() if part != "-" else [] for part in match.groups()
            )
            rows[" ".join(name)] = (arguments, verbs, {*short, *long} - _NO_OPTIONS)
    return rows


def _parser(command: str) -> Any:
    from ros2cli.parser import ros2_parser

    parser = ros2_parser()
    for word in command.split():
        parser = _verbs(parser)[word].fill()
    return parser


def _verbs(parser: Any) -> dict[str, Any]:
    found = [action.choices for action in parser._actions if isinstance(action, argparse._SubParsersAction)]
    return dict(found[0]) if found else {}


@pytest.mark.parametrize("command", _rows())
def test_has_what_the_real_one_has(command: str) -> None:
    arguments, verbs, options = _rows()[command]
    parser = _parser(command)
    ours = [
        a for a in parser._actions if not a.option_strings and not isinstance(a, argparse._SubParsersAction)
    ]
    assert [action.dest for action in ours] == arguments
    assert set(verbs) <= set(_verbs(parser))
    assert options <= set(parser._option_string_actions)
    assert all(
        action.help for action in parser._actions if not isinstance(action, argparse._SubParsersAction)
    )


def test_nothing_was_left_out_of_the_table() -> None:
    assert len(_rows()) == 69


@pytest.mark.parametrize("words", [*itertools.permutations(["-r 2", "--once", "/t std_msgs/String {a:1}"])])
def test_options_stand_before_or_behind(words: tuple[str, ...]) -> None:
    args = _parsed("topic", "pub", *" ".join(words).split())
    assert (args.rate, args.once, args.topic_name, args.message_type, args.values) == (
        2.0, True, "/t", "std_msgs/String", "{a:1}",
    )  # fmt: skip


@pytest.mark.parametrize(
    "words",
    ["-r 2 /t t {}", "/t -r 2 t {}", "/t t -r 2 {}", "/t t {} -r2", "/t t --rate=2 {}", "/t t --rat 2 {}"],
)
def test_options_stand_in_between(words: str) -> None:
    args = _parsed("topic", "pub", *words.split())
    assert (args.rate, args.topic_name, args.message_type, args.values) == (2.0, "/t", "t", "{}")


def test_what_looks_like_an_option() -> None:
    assert _parsed("topic", "pub", "/t", "t", "-t", "2", "--", "- 1").values == "- 1"
    assert _parsed("param", "set", "/n", "p", "-5").value == "-5"
    assert _parsed("topic", "echo", "/t", "--once", "t").message_type == "t"
    assert _parsed("service", "call", "/s", "t", "-r", "1", "{}").values == "{}"
    assert _parsed("action", "send_goal", "/a", "t", "-f", "{}").goal == "{}"


@pytest.mark.parametrize(
    ("words", "complaint"),
    [
        ("topic pub /t t -r", "-r/--rate: expected one argument"),
        ("topic pub /t t -r 0", "value must be a positive float"),
        ("topic pub /t t --stdin {}", "not allowed with argument --stdin"),
        ("topic pub /t t -1 -t 2", "not allowed with argument -1/--once"),
        ("topic echo /t t x", "unrecognized arguments: x"),
        ("topic hz -w 0 /t", "value must be a positive integer"),
        ("topic echo --qos-reliability often /t", "invalid choice: 'often'"),
        ("node list --nosuch", "unrecognized arguments: --nosuch"),
        ("node info", "the following arguments are required: node_name"),
    ],
)
def test_wrong_usage(words: str, complaint: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as ended:
        _parsed(*words.split())
    assert ended.value.code == 2
    assert complaint in capsys.readouterr().err


def _parsed(*words: str) -> argparse.Namespace:
    from ros2cli.parser import ros2_parser

    args: argparse.Namespace = ros2_parser().parse_args(words)
    return args
