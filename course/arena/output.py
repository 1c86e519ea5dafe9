"""Terminal output cut into lines, with colours removed and its amount bounded."""

from __future__ import annotations

import re

MAX_LINE = 4000
MAX_TOTAL = 1024 * 1024
_CONTROL = re.compile(r"\x1b\[[0-?]*[ -/]*[@-~]|\x1b[@-Z\\-_]|[\x00-\x08\x0b-\x1f\x7f]")


class LineSplitter:
    """Bytes in, finished lines out. `dropped`: bytes beyond what is kept.

    A line longer than MAX_LINE is cut there; after MAX_TOTAL nothing more is kept.
    """

    def __init__(self) -> None:
        self.dropped = 0
        self._kept = 0
        self._open = b""

    def feed(self, data: bytes) -> list[str]:
        """The lines that `data` finishes."""
        if self._kept >= MAX_TOTAL:
            self.dropped += len(data)
            return []
        self._kept += len(data)
        *lines, self._open = (self._open + data).split(b"\n")
        if len(self._open) > 2 * MAX_LINE:
            self.dropped += len(self._open) - MAX_LINE
            self._open = self._open[:MAX_LINE]
        return [self._clean(line) for line in lines]

    def rest(self) -> list[str]:
        """The last line, when it had no line end."""
        last, self._open = self._open, b""
        return [self._clean(last)] if last else []

    def _clean(self, line: bytes) -> str:
        if len(line) > MAX_LINE:
            self.dropped += len(line) - MAX_LINE
        text = line[:MAX_LINE].decode("utf-8", errors="replace")
        return _CONTROL.sub("", text)
