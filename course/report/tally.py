"""How far a long command is: a count with its pace, and the bar that shows it."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from rich.console import Console

from course.report.console import put


class Tally:
    """What has been done up to now, and how fast. before: how much of it an earlier run had done."""

    def __init__(self, total: int, before: int = 0) -> None:
        self.total = total
        self.done = before
        self._before = before
        self._since = time.monotonic()
        self._ends: Counter[str] = Counter()

    def count(self, end: str) -> None:
        """One more is done, and ended like this."""
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
def progress(console: Console) -> Iterator[Callable[[Tally, str | None], None]]:
    """Yields what shows a tally: a bar on a terminal; elsewhere a plain line for each text."""
    if not console.is_terminal or console.is_dumb_terminal:
        yield lambda tally, done: put(console, f"{done}  ({tally.line()})") if done else None
        return
    from rich.progress import BarColumn, Progress, TextColumn

    columns = (BarColumn(bar_width=24), TextColumn("{task.description}", markup=False))
    with Progress(*columns, console=console, transient=True) as shown:
        task = shown.add_task("", total=None)

        def show(tally: Tally, done: str | None) -> None:
            shown.update(task, total=tally.total, completed=tally.done, description=tally.line())

        yield show
