"""What is going on during a check: one moving line on a terminal, a plain line each elsewhere.

Written to standard error, so that standard output holds the result alone.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from rich.console import Console
from rich.text import Text

from course.report import safe
from course.report.console import put

FRAMES = "|/-\\"
FRAMES_PER_SECOND = 6


class _Line:
    """The moving line: a turning bar, what is being done, and since when."""

    def __init__(self, message: str) -> None:
        self._message = message
        self._since = time.monotonic()

    def say(self, message: str) -> None:
        self._message = safe.one_line(message)

    def __rich__(self) -> Text:
        seconds = time.monotonic() - self._since
        frame = FRAMES[int(seconds * FRAMES_PER_SECOND) % len(FRAMES)]
        return Text(f"{frame} {self._message}  {seconds:.0f} s", no_wrap=True, overflow="ellipsis")


@contextmanager
def activity(console: Console, message: str, *, quiet: bool = False) -> Iterator[Callable[[str], None]]:
    """Yields a function that takes what is being done now; `quiet` shows nothing off a terminal."""
    if console.is_terminal and not console.is_dumb_terminal:
        with _moving(console, message) as say:
            yield say
    else:
        say = (lambda _: None) if quiet else _plain(console)
        say(message)
        yield say


@contextmanager
def _moving(console: Console, message: str) -> Iterator[Callable[[str], None]]:
    # Only a terminal needs it, and it is slow to import.
    from rich.live import Live

    line = _Line(message)
    live = Live(
        get_renderable=line.__rich__,
        console=console,
        refresh_per_second=FRAMES_PER_SECOND,
        transient=True,
        redirect_stdout=False,
        redirect_stderr=False,
    )
    with live:
        yield line.say


def _plain(console: Console) -> Callable[[str], None]:
    said: set[str] = set()

    def say(message: str) -> None:
        if message not in said:
            said.add(message)
            put(console, safe.one_line(message))

    return say
