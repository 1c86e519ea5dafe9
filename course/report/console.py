"""The consoles on which everything is printed, and the few layout helpers that renderers share.

Markup, emoji codes and automatic highlighting are off: text is shown as it is.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import TextIO

from rich.console import Console
from rich.text import Text
from rich.theme import Theme

# Longer lines are hard to read, however wide the terminal is.
WIDEST = 100
# Colors of the terminal's own sixteen, and no backgrounds: both light and dark terminals exist.
STYLES = {"markdown.code": "cyan", "markdown.table.border": "dim", "markdown.table.header": "bold"}


def open_console(stream: TextIO | None = None, *, width: int | None = None) -> Console:
    """A console on `stream` (standard output by default), at most `WIDEST` columns wide."""
    console = Console(
        file=stream or sys.stdout, markup=False, emoji=False, highlight=False, theme=Theme(STYLES)
    )
    console.width = min(width or console.width, WIDEST)
    return console


def error_console() -> Console:
    """The console for progress, notices and errors: standard error."""
    return open_console(sys.stderr)


@contextmanager
def paged(console: Console) -> Iterator[None]:
    """Send everything printed inside to the environment's PAGER; without a terminal, print it directly."""
    if not console.is_terminal:
        yield
        return
    # `less` shows colors only when told to.
    styles = "r" in os.environ.get("LESS", "").lower()
    with console.pager(styles=styles):
        yield


def is_plain(console: Console) -> bool:
    """Whether this console shows no color, so that words and marks must carry everything."""
    return console.no_color or console.color_system is None


def put(console: Console, text: str | Text = "", style: str = "") -> None:
    """Print one line, neither wrapped nor cut: for text that people copy or click."""
    line = Text(text, style) if isinstance(text, str) else text
    console.print(line, soft_wrap=True)


def put_prose(console: Console, text: str | Text, *, first: str = "", rest: str | None = None) -> None:
    """Print wrapped text; `first` goes before its first line, `rest` (default: spaces) before the others."""
    prose = Text(text) if isinstance(text, str) else text
    hanging = " " * len(first) if rest is None else rest
    room = max(console.width - max(len(first), len(hanging)), 20)
    for row, line in enumerate(prose.wrap(console, room)):
        line.rstrip()
        put(console, Text.assemble(hanging if row else first, line))


def with_code(console: Console, text: str, style: str = "") -> Text:
    """`text` with its `code` in backquotes colored; without color the backquotes stay."""
    parts = text.split("`")
    if is_plain(console) or len(parts) % 2 == 0:
        return Text(text, style)
    return Text.assemble(*((part, "cyan" if odd % 2 else "") for odd, part in enumerate(parts)), style=style)


def put_steps(console: Console, steps: Iterable[tuple[str, str]]) -> None:
    """Print what to type next: pairs of a command and what it is for."""
    rows = list(steps)
    width = max((len(command) for command, _ in rows), default=0)
    put(console, "Type next:", "bold")
    for command, why in rows:
        put(console, Text.assemble("  ", (command.ljust(width), "cyan"), f"  {why}"))


def put_course_passed(console: Console) -> None:
    put(console, "You have passed every exercise in this course. Well done!", "bold green")
    put(console)


def number(value: float) -> str:
    """Points as a person writes them: 2, 0.5."""
    return f"{value:g}"
