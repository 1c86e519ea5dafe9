"""Whether a command of ours could be typed like that. Nothing of it is run, options' callbacks included."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

import typer
from typer.exceptions import TyperException


def complaint(words: Sequence[str]) -> str | None:
    """What is wrong with the words after `ros2course`, as the command line says it; None when nothing."""
    group = _group()
    whole = group.context_class(group, info_name=group.name, **group.context_settings)
    return _said_of(group, whole, words)


def _said_of(command: Any, context: Any, words: Sequence[str]) -> str | None:
    """The same for a command, or for one that has commands of its own."""
    said, rest = _parsed(command, context, words)
    if said or not rest:
        return said
    below: Mapping[str, Any] = getattr(command, "commands", {})
    if not below:
        return f"unexpected argument `{rest[0]}`"
    inner = below.get(rest[0])
    if inner is None:
        return _unknown(rest[0], list(below))
    return _said_of(inner, inner.context_class(inner, info_name=inner.name, parent=context), rest[1:])


@cache
def _group() -> Any:
    from course.cli.app import app  # it brings every command: only who asks pays for that

    return typer.main.get_command(app)


def _parsed(command: Any, context: Any, words: Sequence[str]) -> tuple[str | None, list[str]]:
    """What is wrong with its options and arguments, and the words that are left over."""
    try:
        given, rest, _order = command.make_parser(context).parse_args(list(words))
    except TyperException as error:
        return str(error), []
    missing = [one.name for one in command.params if one.required and given.get(one.name) in (None, ())]
    asks_for_help = bool(given.get("help"))
    return (f"`{missing[0]}` is missing" if missing and not asks_for_help else None), rest


def _unknown(name: str, known: Sequence[str]) -> str:
    from course.content.names import did_you_mean

    return f"there is no command `{name}`{did_you_mean(name, known)}"
