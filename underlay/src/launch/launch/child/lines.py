"""Bytes as they come, lines as they are shown."""

from __future__ import annotations


class Lines:
    """Whole lines at once; the rest waits for its end."""

    def __init__(self) -> None:
        self._rest = b""

    def feed(self, data: bytes) -> list[str]:
        *whole, self._rest = (self._rest + data).split(b"\n")
        return [_text(line) for line in whole]

    def rest(self) -> list[str]:
        """What was never ended by a new line."""
        rest, self._rest = self._rest, b""
        return [_text(rest)] if rest else []


def _text(line: bytes) -> str:
    return line.decode("utf-8", "replace").removesuffix("\r")
