"""Whatever is typed: a usage error or one line, never a traceback."""

from __future__ import annotations

import contextlib
import io
import json
import random
import subprocess

import pytest

from course.isolation.levels import isolated
from course.rosenv import find_ros
from tests.underlay.cli.place import environment

_WORDS = (
    "-h --help -r -1 --once --rate --rate=2 --no-daemon --nosuch -- - --qos-depth 0 -5 1e9 nan inf {} [] {a: "
    "[ : ' \" ä \0 /a//b / ~ ~/x {node} a/b/c std_msgs/msg/String std_msgs/String . .. * -tvc --spin-time "
    "--filter m. __import__('os') %s %(x)s \\ \n"
).split(" ")
# In one process, for each start of Python costs more than a hundred lines.
_RUN_ALL = """
import contextlib, io, json, sys
from ros2cli.main import main
told = []
for words in json.load(sys.stdin):
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            code = main(words)
        except SystemExit as end:
            code = end.code
        except BaseException as error:
            code = repr(error)
    told.append([words, code, err.getvalue()])
json.dump(told, sys.stdout)
"""


def _lines(count: int, begin: list[list[str]]) -> list[list[str]]:
    dice = random.Random(3)
    return [[*dice.choice(begin), *dice.choices(_WORDS, k=dice.randint(0, 5))] for _ in range(count)]


def _verbs() -> list[list[str]]:
    from ros2cli.registry import COMMANDS, VERBS

    return [[], *([name] for name in COMMANDS), *([name, verb] for name in VERBS for verb in VERBS[name])]


@pytest.mark.slow
def test_any_line_is_parsed_or_refused() -> None:
    from ros2cli.parser import ros2_parser

    for words in _lines(150, _verbs()):
        said = io.StringIO()
        with contextlib.redirect_stderr(said), contextlib.redirect_stdout(said):
            try:
                assert callable(ros2_parser().parse_args(words).main), words
            except SystemExit as ended:
                assert ended.code in (0, 2), words


@pytest.mark.slow
def test_any_line_is_completed_or_not(monkeypatch: pytest.MonkeyPatch) -> None:
    from ros2cli import daemon, graph
    from ros2cli.completion import offers
    from ros2cli.parser import ros2_parser
    from ros2cli.snapshot import Snapshot

    monkeypatch.setenv("AMENT_PREFIX_PATH", str(find_ros().prefix))
    monkeypatch.setattr(daemon, "is_allowed", lambda: False)
    monkeypatch.setattr(graph, "_look", lambda args: Snapshot((), ()))
    quick = [verb for verb in _verbs() if verb[:1] not in (["param"], ["launch"])]
    for words in _lines(150, quick):
        assert isinstance(offers(ros2_parser(), " ".join(["ros2", *words])), list), words


def _told(lines: list[list[str]]) -> list[tuple[list[str], object, str]]:
    with isolated() as around:
        done = subprocess.run(
            [*around.prefix, str(find_ros().python), "-c", _RUN_ALL],
            env={**environment(), **around.environment, "ROS2COURSE_ARENA": "1"},
            input=json.dumps(lines), capture_output=True, text=True, timeout=120, check=True,
        )  # fmt: skip
    return [(words, code, said) for words, code, said in json.loads(done.stdout)]


def _assert_told_plainly(lines: list[list[str]]) -> None:
    for words, code, said in _told(lines):
        assert code in (0, 1, 2), (words, code)
        assert "Traceback" not in said, words
        if code == 1:
            assert said.count("\n") <= 1 + "".join(words).count("\n"), (words, said)
            assert not said.startswith(("ValueError:", "TypeError:", "AttributeError:", "KeyError:")), said


@pytest.mark.slow
def test_what_needs_no_nodes_ends_in_one_line() -> None:
    verbs = [["interface", verb] for verb in ("show", "proto", "package", "list", "packages")]
    verbs += [["pkg", verb] for verb in ("prefix", "xml", "executables")]
    _assert_told_plainly(_lines(80, [*verbs, ["run"], ["run", "--prefix"]]))


@pytest.mark.slow
def test_types_and_values_of_all_kinds() -> None:
    types = [
        "std_msgs/msg/String",
        "std_msgs/Int32",
        "nosuch/msg/A",
        "std_msgs/msg/Nosuch",
        "a",
        "",
        "a/b/c/d",
    ]
    values = [
        "{",
        "5",
        "[1]",
        "{data: [1}",
        "{nosuch: 1}",
        "{data: {a: 1}}",
        "null",
        "- a",
        "{1: 2}",
        "!!x y",
        "\t",
    ]
    names = ["/t", "t t", "/t/", "//", "", "1a", "/{node}", "~/a"]
    pub = ["topic", "pub", "--once", "--max-wait-time-secs", "0.01"]
    lines = [[*pub, "/t", kind, value] for kind in types[:2] for value in values]
    lines += [[*pub, "/t", kind] for kind in types[2:]] + [[*pub, name, types[0]] for name in names]
    call = ["service", "call", "/s"]
    meant = ("null", "{data: {a: 1}}")  # taken for a request, which waits for its server
    lines += [[*call, "std_srvs/srv/SetBool", value] for value in values if value not in meant]
    lines += [[*call, kind] for kind in types]
    lines += [["action", "send_goal", "/a", kind] for kind in types]
    lines += [["topic", "echo", "--timeout", "0.1", name, types[0]] for name in names]
    _assert_told_plainly(lines)
