"""Bytes as they come, lines as they are shown."""

from __future__ import annotations


class Lines:
    """Whole lines at once; the rest waits for its end."""

    def __init__(self) -> None:
        self._rest: list[bytes] = []

    def feed(self, data: bytes) -> list[str]:
        if b"\n" not in data:
            self._rest.append(data)
            return []
        *whole, rest = b"".join([*self._rest, data]).split(b"\n")
        self._rest = [rest] if rest else []
        return [_text(line) for line in whole]

    def rest(self) -> list[str]:
        """What was never ended by a new line."""
        rest, self._rest = b"".join(self._rest), []
        return [_text(rest)] if rest else []


def _text(line: bytes) -> str:
    return line.decode("utf-8", "replace").removesuffix("\r")
