"""The parsers of `ros2`, its commands and their verbs; a parser is filled only when it is entered."""

from __future__ import annotations

import argparse
import importlib
import importlib.util
import os
import sys
from collections.abc import Callable, Mapping
from functools import partial
from types import ModuleType
from typing import Any

from ros2cli.examples import epilog
from ros2cli.registry import ALIASES, COMMANDS, ELSEWHERE, HIDDEN, VERBS
from ros2cli.word_order import options_first

DESCRIPTION = "ros2 is an extensible command-line tool for ROS 2."
_BUFFERING = (
    "Do not force line buffering in stdout and instead use the python default buffering, which might be "
    "affected by PYTHONUNBUFFERED/-u and depends on whatever stdout is interactive or not"
)


class LazyParser(argparse.ArgumentParser):
    """Gets its arguments from `fill` when something is to be parsed by it."""

    def __init__(self, *args: Any, fill: Callable[[LazyParser], None] | None = None, **kwargs: Any) -> None:
        super().__init__(*args, formatter_class=argparse.RawDescriptionHelpFormatter, **kwargs)
        self._fill = fill

    def fill(self) -> LazyParser:
        """Add the arguments, unless they are there."""
        fill, self._fill = self._fill, None
        if fill is not None:
            fill(self)
        return self

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        self.fill()
        words = sys.argv[1:] if args is None else args
        return super().parse_known_args(options_first(self, words), namespace)


def ros2_parser() -> LazyParser:
    """The parser of the whole command line. `main` of what it returns is what to call with it."""
    parser = LazyParser(prog="ros2", description=DESCRIPTION)
    parser.add_argument("--use-python-default-buffering", action="store_true", help=_BUFFERING)
    choices = {name: partial(_fill_command, name) for name in sorted([*COMMANDS, *HIDDEN])}
    _add_choices(parser, "ros2", COMMANDS, choices)
    return parser


def _fill_command(name: str, parser: LazyParser) -> None:
    if name in ELSEWHERE:
        return _fill_elsewhere(name, parser)
    parser.description = COMMANDS[ALIASES.get(name, name)]
    name = ALIASES.get(name, name)
    parser.epilog = epilog(name)
    module = _command_module(name)
    if module is not None:
        _fill_from(module, parser)
    if name in VERBS:
        choices = {verb: partial(_fill_verb, name, verb) for verb in VERBS[name]}
        _add_choices(parser, parser.prog, VERBS[name], choices)
    return None


def _fill_verb(command: str, verb: str, parser: LazyParser) -> None:
    parser.description = VERBS[command][verb]
    parser.epilog = epilog(f"{command} {verb}")
    _fill_from(importlib.import_module(f"ros2cli.verbs.{command}.{verb}"), parser)


def _fill_from(module: ModuleType, parser: LazyParser) -> None:
    module.add_arguments(parser)
    if hasattr(module, "main"):
        parser.set_defaults(main=module.main)


def _fill_elsewhere(name: str, parser: LazyParser) -> None:
    """Whatever follows the command, the answer is the same."""
    parser.add_argument("rest", nargs=argparse.REMAINDER)
    parser.prefix_chars = ""
    parser.set_defaults(
        main=lambda args: (
            f"`ros2 {name}` is not offered here. It comes with an installed ROS 2: "
            f"sudo apt install {ELSEWHERE[name]}"
        )
    )


def _add_choices(
    parser: LazyParser,
    prog: str,
    listed: Mapping[str, str],
    choices: Mapping[str, Callable[[LazyParser], None]],
) -> None:
    width = max(map(len, listed))
    listing = "\n".join(f"{name.ljust(width)}  {text}" for name, text in listed.items())
    hint = f"Call `{prog} <command> -h` for more detailed usage."
    sub = parser.add_subparsers(title="Commands", description=listing, metavar=hint)
    if parser.get_default("main") is None:
        parser.set_defaults(main=lambda args: parser.print_help())
    # Completion looks into a parser before anything is parsed by it.
    asked = os.environ.get("COMP_LINE", "").split() if "_ARGCOMPLETE" in os.environ else []
    for name, fill in choices.items():
        entered = sub.add_parser(name, fill=fill)
        if name in asked:
            entered.fill()


def _command_module(name: str) -> ModuleType | None:
    full = f"ros2cli.commands.{name}"
    return importlib.import_module(full) if importlib.util.find_spec(full) else None
