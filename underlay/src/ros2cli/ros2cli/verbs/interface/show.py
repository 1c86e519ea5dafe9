"""`ros2 interface show`: the definition of an interface, with those of its fields within it."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from pathlib import Path

from ros2cli.verbs.interface.asked_type import add_type_argument, asked_type, definition_path
from ros2cli.verbs.interface.definition import Line

_TYPE = (
    'Show an interface definition (e.g. "example_interfaces/msg/String"). Passing "-" reads the argument '
    'from stdin (e.g. "ros2 topic type /chatter | ros2 interface show -").'
)
_ALL_COMMENTS = "Show all comments, including for nested interface definitions"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take the type, and which comments are wanted."""
    add_type_argument(parser, _TYPE)
    group = parser.add_mutually_exclusive_group()
    group.add_argument("--all-comments", action="store_true", help=_ALL_COMMENTS)
    group.add_argument("--no-comments", action="store_true", help="Show no comments or whitespace")


def main(args: argparse.Namespace) -> None:
    """Print it; fields of a message type are followed by its fields, one tab further in."""
    name = asked_type(args)
    for line in _lines(name, not args.no_comments, args.all_comments):
        print(line)


def _lines(name: str, comments: bool, nested_comments: bool) -> Iterator[str]:
    """Yield what is to be shown. Without comments there are no empty lines, either."""
    path = Path(definition_path(name))
    package = name.split("/")[0]
    for text in path.read_text(encoding="utf-8").splitlines():
        line = Line(text.rstrip())
        shown = line.text if comments else line.code
        if comments or shown:
            yield shown
        nested = line.nested(package) if path.suffix != ".idl" else None
        if nested:
            yield from ("\t" + inner for inner in _lines(nested, nested_comments, nested_comments))
