"""Run as a program: says which commands `ros2` would reject as invalid. Runs none of them.

Reads [[words, mentioned, only_name], ...] from its input, and prints a list with a complaint or null for
each. It uses the parsers of `ros2` itself, found through PYTHONPATH, and imports nothing from the course.
"""

from __future__ import annotations

import contextlib
import importlib
import io
import itertools
import json
import sys
from typing import Any

ANYTHING = "..."
# A word that is valid as a name and as a number.
_FILLER = "1"
# A `...` is replaced by fewer words than this, which is enough for any verb.
_MOST = 4
# The number of words in a command's name: `topic echo`.
_NAME = 2


def main() -> None:
    asked = json.load(sys.stdin)
    # One parser for all: it fills its parts only once.
    parser = importlib.import_module("ros2cli.parser").ros2_parser()
    json.dump([_complaint(parser, *one) for one in asked], sys.stdout)


def _complaint(parser: Any, words: list[str], mentioned: bool, only_name: bool) -> str | None:
    """None if the line, or a variant of it, is valid."""
    if only_name:
        return _parse(parser, [*words[:_NAME], "--help"])  # what follows may be prose
    first = None
    for variant in _variants(words, mentioned):
        complaint = _parse(parser, variant)
        if complaint is None:
            return None
        first = first or complaint
    return first


def _variants(words: list[str], mentioned: bool) -> Any:
    """The command with words in place of each `...`. One that is only mentioned may lack arguments."""
    if mentioned:
        words = [*words[:_NAME], ANYTHING, *words[_NAME:], ANYTHING]
    gaps = words.count(ANYTHING)
    for chosen in itertools.product(range(_MOST), repeat=gaps):
        fill = iter(chosen)
        yield [part for word in words for part in ([_FILLER] * next(fill) if word == ANYTHING else [word])]


def _parse(parser: Any, words: list[str]) -> str | None:
    errors = io.StringIO()
    with contextlib.redirect_stderr(errors), contextlib.redirect_stdout(io.StringIO()):
        try:
            parser.parse_args(words)
        except SystemExit as ended:
            return _reason(errors.getvalue()) if ended.code else None
    return None


def _reason(printed: str) -> str:
    """argparse's message after `error:`, without the argument's name for an invalid choice."""
    said = " ".join(printed.rpartition(": error: ")[2].split())
    return said[said.index("invalid choice") :] if "invalid choice" in said else said


if __name__ == "__main__":
    main()
