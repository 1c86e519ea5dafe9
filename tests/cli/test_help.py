"""Every command explains itself with examples that are right."""

from __future__ import annotations

import re
import shlex

import pytest
from typer.main import get_command

from course.cli.app import app
from course.cli.main import main
from course.cli.words import global_options_first

NAMES = sorted(get_command(app).commands)  # type: ignore[attr-defined]
EXPECTED = {"init", "next", "check", "hint", "list", "show", "reset", "solution", "shell", "env", "doctor"}
EXPECTED |= {"new", "schema", "validate", "build-underlay", "play", "bundle", "grade", "regrade", "similar"}
EXPECTED |= {"report", "serve", "evidence", "watch"}


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
    """How many words stand before the command."""
    return 2 if words[0] in ("--home", "--course") else 0


def test_the_program_s_help_names_every_command(capsys: pytest.CaptureFixture[str]) -> None:
    text = help_of(capsys)
    assert [name for name in NAMES if not re.search(rf"^  {name} ", text, re.M)] == []
    assert "..." not in text.split("Commands:")[1].split("Examples:")[0], "no summary is cut"
    assert max(map(len, text.splitlines())) <= 80
