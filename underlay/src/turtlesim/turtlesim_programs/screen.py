"""The upper part of a terminal shows a picture; below it, lines scroll as usual."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import TextIO

_LINES_BELOW = 6
_SMALLEST = 8


class Screen:
    """Draws on `terminal`, if it is one and large enough, and follows its size."""

    def __init__(self, terminal: TextIO) -> None:
        self._terminal = terminal
        self._size: os.terminal_size | None = None
        self._shown: list[str] = []

    def draw(self, picture: Callable[[int], list[str]]) -> None:
        """Show `picture(height)`; its lines are twice as many characters wide."""
        if not self._terminal.isatty():
            return
        size = os.get_terminal_size(self._terminal.fileno())
        height = min(size.lines - _LINES_BELOW, size.columns // 2)
        if height < _SMALLEST:
            self.close()
            return
        if size != self._size:
            self._open(size, height)
        lines = picture(height)
        changed = [(row, line) for row, line in enumerate(lines) if line not in self._shown[row : row + 1]]
        if changed:
            self._write("\x1b7" + "".join(f"\x1b[{row + 1};1H{line}" for row, line in changed) + "\x1b8")
        self._shown = lines

    def close(self) -> None:
        """Let the whole terminal scroll again."""
        if self._size:
            self._write(f"\x1b[r\x1b[{self._size.lines};1H\n")
        self._size = None

    def _open(self, size: os.terminal_size, height: int) -> None:
        # What is there moves up and out of the way; nothing is erased.
        away = "\n" * size.lines
        self._write(f"\x1b[r{away}\x1b[{height + 1};{size.lines}r\x1b[{height + 1};1H")
        self._size, self._shown = size, []

    def _write(self, text: str) -> None:
        self._terminal.write(text)
        self._terminal.flush()
