"""A command's progress: a moving line, or a count with its rate; plain lines if there is no terminal.

It goes to standard error, so that standard output contains only the result.
"""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Protocol

from rich.console import Console
from rich.text import Text

from course.report import sanitize
from course.report.console import put

FRAMES = "|/-\\"
FRAMES_PER_SECOND = 6


class _Line:
    """The moving line: a spinner, what is being done, and for how long."""

    def __init__(self, message: str) -> None:
        self._message = message
        self._since = time.monotonic()

    def say(self, message: str) -> None:
        self._message = sanitize.one_line(message)

    def __rich__(self) -> Text:
        seconds = time.monotonic() - self._since
        frame = FRAMES[int(seconds * FRAMES_PER_SECOND) % len(FRAMES)]
        return Text(f"{frame} {self._message}  {seconds:.0f} s", no_wrap=True, overflow="ellipsis")


@contextmanager
def activity(console: Console, message: str, *, quiet: bool = False) -> Iterator[Callable[[str], None]]:
    """Yields a function to call with what is being done now. `quiet`: show nothing without a terminal."""
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
            put(console, sanitize.one_line(message))

    return say


class Show(Protocol):
    """done: text about what was just finished. doing: about what is still going on, for a terminal."""

    def __call__(self, tally: Tally, done: str | None, doing: str = "") -> None: ...


class Tally:
    """How much has been done up to now, and how fast. before: how much of it an earlier run had done."""

    def __init__(self, total: int, before: int = 0) -> None:
        self.total = total
        self.done = before
        self._before = before
        self._since = time.monotonic()
        self._ends: Counter[str] = Counter()

    def count(self, end: str) -> None:
        """Count one more that is done. end: how it ended."""
        self.done += 1
        self._ends[end] += 1

    def line(self) -> str:
        """For example: 12 of 60, 41 a minute, 1:10 left, 8 passed, 4 not passed."""
        done_now = self.done - self._before
        minutes = (time.monotonic() - self._since) / 60
        parts = [f"{self.done} of {self.total}"]
        if done_now and minutes > 0:
            rate = done_now / minutes
            parts.append(f"{rate:.0f} a minute")
            left = round((self.total - self.done) / rate * 60)
            parts.append(f"{left // 60}:{left % 60:02} left")
        parts += [f"{count} {end}" for end, count in self._ends.items()]
        return ", ".join(parts)


@contextmanager
def progress(console: Console) -> Iterator[Show]:
    """Yields a function that shows a tally: as a bar on a terminal, else as a plain line for each text."""
    if not console.is_terminal or console.is_dumb_terminal:
        yield lambda tally, done, doing="": put(console, f"{done}  ({tally.line()})") if done else None
        return
    from rich.progress import BarColumn, Progress, TextColumn

    columns = (BarColumn(bar_width=24), TextColumn("{task.description}", markup=False))
    with Progress(*columns, console=console, transient=True) as shown:
        task = shown.add_task("", total=None)

        def show(tally: Tally, done: str | None, doing: str = "") -> None:
            told = ", ".join(filter(None, (tally.line(), sanitize.one_line(doing))))
            shown.update(task, total=tally.total, completed=tally.done, description=told)

        yield show
