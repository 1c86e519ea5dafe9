"""Every command explains itself with examples that are right."""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
from typer.main import get_command

from course.cli.app import COMMANDS, app
from course.cli.main import main
from course.cli.usage import global_options_first
from course.errors import ExitCode
from tests.cli.conftest import Ros2course

NAMES = sorted(get_command(app).commands)  # type: ignore[attr-defined]
EXPECTED = {"init", "next", "check", "hint", "list", "show", "reset", "solution", "shell", "env", "doctor"}
EXPECTED |= {"new", "schema", "validate", "build-underlay", "play", "bundle", "grade", "regrade", "similar"}
EXPECTED |= {"report", "results", "serve", "evidence", "watch", "review", "api", "pack"}


def help_of(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    assert main([*words, "--help"]) == 0
    return capsys.readouterr().out


def examples(text: str) -> list[str]:
    return re.findall(r"^ +(ros2course .+?)(?:  .*)?$", text.split("Examples:")[1], re.M)


def test_all_commands_are_there() -> None:
    assert set(NAMES) == EXPECTED


@pytest.mark.parametrize("name", NAMES)
def test_help_has_a_sentence_and_an_example_of_this_command(
    capsys: pytest.CaptureFixture[str], name: str
) -> None:
    text = help_of(capsys, name)
    assert re.search(r"^  [A-Z].*[.:]", text, re.M)
    assert "Examples:" in text
    assert re.search(rf"ros2course (.* )?{name}\b", text.split("Examples:")[1])
    assert max(map(len, text.splitlines())) <= 80


@pytest.mark.parametrize("name", [*NAMES, ""])
def test_every_example_can_be_typed(capsys: pytest.CaptureFixture[str], name: str) -> None:
    text = help_of(capsys, *filter(None, [name]))
    for example in examples(text):
        if "COMMAND" in example or ">>" in example:
            continue
        words = global_options_first(shlex.split(example)[1:])
        root = get_command(app)
        context = root.make_context("ros2course", words)
        rest = words[-(len(words) - _options(words)) :]
        command = root.commands[rest[0]]  # type: ignore[attr-defined]
        command.make_context(rest[0], rest[1:], parent=context)


def _options(words: list[str]) -> int:
    """How many words precede the command."""
    return 2 if words[0] in ("--home", "--course") else 0


def test_the_list_says_what_each_command_says_first() -> None:
    for command in COMMANDS:
        assert command.loaded.help.replace("\n", " ").startswith(command.help)


def test_the_list_imports_no_command() -> None:
    code = (
        "import sys; from course.cli.main import main; main(sys.argv[1:])\n"
        "print([name for name in sys.modules if name.startswith('course.')], file=sys.stderr)"
    )
    done = subprocess.run([sys.executable, "-c", code, "--help"], capture_output=True, text=True, check=True)
    assert "course.cli.app" in done.stderr
    rooms = {name.split(".")[1] for name in re.findall(r"'(course\.[\w.]+)'", done.stderr)}
    assert rooms <= {"cli", "errors"}


def test_without_an_optional_tool_the_others_work(
    ros2course: Ros2course, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    for name in [name for name in sys.modules if name.startswith("course_similar")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "course_similar", None)
    (similar,) = (command for command in COMMANDS if command.name == "similar")
    monkeypatch.delitem(similar.__dict__, "loaded", raising=False)
    run = ros2course("similar", str(tmp_path))
    assert run.code == ExitCode.MISSING_HERE
    assert "'scanoss-winnowing<" in run.err and "ros2course[" not in run.err
    assert ros2course("schema").code == ros2course("--help").code == 0


def test_the_program_s_help_names_every_command(capsys: pytest.CaptureFixture[str]) -> None:
    text = help_of(capsys)
    assert [name for name in NAMES if not re.search(rf"^  {name} ", text, re.M)] == []
    assert "..." not in text.split("Commands:")[1].split("Examples:")[0], "no summary is cut"
    assert max(map(len, text.splitlines())) <= 80
