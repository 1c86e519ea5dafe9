"""A command line in words, as a shell splits it, but for the substitutions in it: these stay whole."""

from __future__ import annotations


def split(text: str) -> list[str]:
    """Quotes go, and what they held stays together. Raises ValueError for a quote that is not closed."""
    splitter = _Splitter()
    at = 0
    while at < len(text):
        size = _substitution_size(text, at)
        splitter.take(text[at : at + size] if size else text[at], whole=bool(size))
        at += size or 1
    return splitter.end()


class _Splitter:
    def __init__(self) -> None:
        self._words: list[str] = []
        self._word: str | None = None
        self._quote = ""

    def take(self, piece: str, whole: bool) -> None:
        if whole:
            self._word = (self._word or "") + self._unescaped(piece)
        elif self._quote and piece != self._quote:
            self._word = (self._word or "") + piece
        elif piece == self._quote:
            self._quote = ""
        elif piece in "'\"":
            self._quote, self._word = piece, self._word or ""
        elif piece.isspace():
            self._finish()
        else:
            self._word = (self._word or "") + piece

    def _unescaped(self, piece: str) -> str:
        """What a backslash protects from being a quote or a space; a dollar's is left for substitutions."""
        literal = self._quote == "'" or (self._quote and piece[-1] not in '"\\')
        return piece if piece[0] != "\\" or piece == "\\$" or literal else piece[1:]

    def end(self) -> list[str]:
        if self._quote:
            raise ValueError("No closing quotation")
        self._finish()
        return self._words

    def _finish(self) -> None:
        if self._word is not None:
            self._words.append(self._word)
        self._word = None


def _substitution_size(text: str, start: int) -> int:
    """How long what stands at `start` is as a whole: a substitution, or a backslash and what it is for."""
    if text[start] == "\\":
        return 2
    if not text.startswith("$(", start):
        return 0
    depth = 0
    for at in range(start + 1, len(text)):
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        if depth == 0:
            return at + 1 - start
    return 0
