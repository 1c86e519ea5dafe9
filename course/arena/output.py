"""Terminal output cut into lines, with colours removed and its amount bounded."""

from __future__ import annotations

import re

MAX_LINE = 4000
MAX_TOTAL = 1024 * 1024
MAX_TAIL = 8192
# What a line costs beside its bytes: a million empty lines are no small amount.
_LINE_COST = 50
_CONTROL = re.compile(
    r"\x1b[\]PX^_][^\x07\x1b]*(?:\x07|\x1b\\)?"  # window titles, links and other long commands
    r"|\x1b\[[0-?]*[ -/]*[@-~]"  # colours and movements
    r"|\x1b[ -/]*[0-~]"
    r"|[\x00-\x08\x0b-\x1f\x7f-\x9f]"
)


class LineSplitter:
    """Bytes in, finished lines out. `dropped`: bytes beyond what is kept.

    A line longer than MAX_LINE is cut there. After MAX_TOTAL only the last MAX_TAIL bytes are
    kept, for the traceback that may end a flood; `rest` gives them.
    """

    def __init__(self) -> None:
        self.dropped = 0
        self._kept = 0
        self._open = b""
        self._tail = b""

    def feed(self, data: bytes) -> list[str]:
        """The lines that `data` finishes."""
        if self._kept >= MAX_TOTAL:
            self._keep_tail(data)
            return []
        *lines, self._open = (self._open + data).split(b"\n")
        self._kept += len(data) + _LINE_COST * len(lines)
        if len(self._open) > 2 * MAX_LINE:
            self.dropped += len(self._open) - MAX_LINE
            self._open = self._open[:MAX_LINE]
        return [self._clean(line) for line in lines]

    def rest(self) -> list[str]:
        """The last line, when it had no line end; after a flood, the last lines."""
        lines = (self._open + self._tail).split(b"\n")
        self._open = self._tail = b""
        return [self._clean(line) for line in (lines if lines[-1] else lines[:-1])]

    def _keep_tail(self, data: bytes) -> None:
        """The tail begins with a whole line, unless it is one very long line."""
        whole = self._open + self._tail + data
        self._open = b""
        tail = whole[-MAX_TAIL:]
        if len(tail) < len(whole):
            tail = tail[tail.find(b"\n") + 1 :]
        self.dropped += len(whole) - len(tail)
        self._tail = tail

    def _clean(self, line: bytes) -> str:
        if len(line) > MAX_LINE:
            self.dropped += len(line) - MAX_LINE
        text = line[:MAX_LINE].decode("utf-8", errors="replace")
        return _CONTROL.sub("", text)
