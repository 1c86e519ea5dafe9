"""Lets options stand anywhere, as in `pub /topic type -r 2 "data: 1"`.

Before Python 3.12.7, argparse takes an argument that may be left out for left out as soon as an option
follows the arguments before it.
"""

from __future__ import annotations

from argparse import OPTIONAL, Action, ArgumentParser
from collections.abc import Sequence


def options_first(parser: ArgumentParser, words: Sequence[str]) -> list[str]:
    """The words with all options in front, each with its value; as they are where it makes no difference."""
    if not _is_in_danger(parser):
        return list(words)
    options: list[str] = []
    others: list[str] = []
    rest = list(words)
    while rest:
        word = rest.pop(0)
        if word == "--":
            return [*options, "--", *others, *rest]
        option = _option(parser, word)
        if option is None and not _looks_like_option(parser, word):
            others.append(word)
            continue
        options.append(word)
        if option is not None and option.nargs is None and not _has_value(parser, word):
            if not rest:  # left for argparse to complain of
                return list(words)
            options.append(rest.pop(0))
    return [*options, *others]


def _is_in_danger(parser: ArgumentParser) -> bool:
    kinds = [action.nargs for action in parser._actions if not action.option_strings]
    options = [action.nargs for action in parser._actions if action.option_strings]
    return len(kinds) > 1 and kinds[-1] == OPTIONAL and all(nargs in (None, 0) for nargs in options)


def _option(parser: ArgumentParser, word: str) -> Action | None:
    """The one that the word means, which may be shortened or have its value in it."""
    known = parser._option_string_actions
    name = word.partition("=")[0]
    if name in known or not word.startswith("-"):
        return known.get(name)
    if not word.startswith("--"):
        return known.get(word[:2])
    fitting = {id(action): action for text, action in known.items() if text.startswith(name)}
    return next(iter(fitting.values())) if len(fitting) == 1 else None


def _has_value(parser: ArgumentParser, word: str) -> bool:
    """Whether it is in the word itself: `--rate=2`, `-r2`."""
    return "=" in word or (not word.startswith("--") and word not in parser._option_string_actions)


def _looks_like_option(parser: ArgumentParser, word: str) -> bool:
    if not word.startswith("-") or word == "-" or " " in word:
        return False
    return bool(parser._has_negative_number_optionals) or not parser._negative_number_matcher.match(word)
