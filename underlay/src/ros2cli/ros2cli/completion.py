"""What the Tab key offers: by argcomplete, or by this where that is not installed.

The shell asks as argcomplete has it: the line in COMP_LINE up to COMP_POINT, the answers to file
descriptor 8, separated by the character in IFS.
"""

from __future__ import annotations

import argparse
import contextlib
import importlib.util
import os
import shlex
from argparse import Action, ArgumentParser, Namespace
from collections.abc import Iterable, Sequence

from ros2cli.errors import CommandError
from ros2cli.parser import LazyParser

_ANSWER_TO = 8


def complete(parser: LazyParser) -> None:
    """Answer the shell, and end."""
    if importlib.util.find_spec("argcomplete"):
        import argcomplete

        argcomplete.autocomplete(parser, exclude=["-h", "--help"])
    line = os.environ["COMP_LINE"].encode()[: int(os.environ["COMP_POINT"])].decode(errors="ignore")
    separator = os.environ.get("IFS", "\013")
    found: list[str] = []
    with contextlib.suppress(CommandError, OSError, LookupError):  # no place to complain in
        found = [text[_kept_by_shell(line) :] for text in offers(parser, line)]
    with open(os.environ.get("_ARGCOMPLETE_STDOUT_FILENAME", _ANSWER_TO), "w", encoding="utf-8") as answers:  # noqa: PTH123
        answers.write(separator.join(found))
    os._exit(0)


def offers(parser: LazyParser, line: str) -> list[str]:
    """What could stand where the line ends."""
    words = _words(line)
    if not words:
        return []
    *before, begun = words[1:] or [""]
    position = _Position(parser)
    for word in before:
        position.go_on(word)
    return [text for text in position.possible(begun) if text.startswith(begun)]


def _kept_by_shell(line: str) -> int:
    """How much of the last word stays where it is: bash completes only what follows a colon."""
    breaks = os.environ.get("_ARGCOMPLETE_COMP_WORDBREAKS", "")
    begun = (_words(line) or [""])[-1]
    return max((begun.rfind(mark) + 1 for mark in ":=" if mark in breaks), default=0)


def _words(line: str) -> list[str]:
    """The words, the last of them being the one that is being typed, which may be empty."""
    for close in ("", '"', "'"):
        try:
            words = shlex.split(line + close)
        except ValueError:
            continue
        return [*words, ""] if line[-1:].isspace() and not close else words
    return []


class _Position:
    """How far the words have led into the parsers."""

    def __init__(self, parser: LazyParser) -> None:
        self._parser: LazyParser = parser.fill()
        self._read: list[str] = []
        self._option: Action | None = None

    def go_on(self, word: str) -> None:
        if self._option is not None:
            self._option = None
        elif word.startswith("-"):
            option = self._parser._option_string_actions.get(word)
            self._option = option if option is not None and option.nargs != 0 else None
        elif word in (commands := _commands(self._parser)):
            self._parser, self._read = commands[word].fill(), []
        else:
            self._read.append(word)

    def possible(self, begun: str) -> Iterable[str]:
        if self._option is not None:
            return self._values(self._option, begun)
        if begun.startswith("-"):
            return sorted(set(self._parser._option_string_actions) - {"-h", "--help"})
        if commands := _commands(self._parser):
            return [] if self._read else list(commands)
        wanted = self._positionals()
        index = min(len(self._read), len(wanted) - 1)
        takes_more = wanted and (
            index == len(self._read) or wanted[-1].nargs in ("*", "+", argparse.REMAINDER)
        )
        return self._values(wanted[index], begun) if takes_more else []

    def _positionals(self) -> Sequence[Action]:
        return [action for action in self._parser._actions if not action.option_strings]

    def _values(self, action: Action, begun: str) -> Iterable[str]:
        if action.choices is not None:
            return [str(choice) for choice in action.choices]
        completer = getattr(action, "completer", None)
        return completer(prefix=begun, parsed_args=self._namespace()) if completer else []

    def _namespace(self) -> Namespace:
        """As far as it is known: what has been read, and what would be without more."""
        values = {action.dest: action.default for action in self._parser._actions}
        names = [action.dest for action in self._positionals()]
        return Namespace(**{**values, **dict(zip(names, self._read, strict=False))})


def _commands(parser: ArgumentParser) -> dict[str, LazyParser]:
    return next(
        (dict(a.choices) for a in parser._actions if isinstance(a, argparse._SubParsersAction)),
        {},
    )
