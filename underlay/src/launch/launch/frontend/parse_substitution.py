"""Substitutions written in a text: `$(var name)`, `$(env HOME)`, `$(find-pkg-share package)` and so on."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.substitutions.text_substitution import TextSubstitution

_START = re.compile(r"\\\$|\$\(\s*([\w-]+)\s*")
_BLANKS = re.compile(r"\s*")


@dataclass
class Argument:
    """One word after the name of a substitution; `quote` is what stood around it, or nothing."""

    quote: str = ""
    parts: list[Substitution] = field(default_factory=list)


def parse_substitution(text: str) -> list[Substitution]:
    """The text as substitutions. `\\$` is a dollar that begins none. Raises SubstitutionFailure."""
    return _Reader(text).template("")


class _Reader:
    def __init__(self, text: str) -> None:
        self._text = text
        self._at = 0

    def template(self, quote: str) -> list[Substitution]:
        """Up to the closing quote, or to the end."""
        parts: list[Substitution] = []
        plain = ""
        while self._at < len(self._text) and (not quote or self._text[self._at] != quote):
            if (found := self._substitution()) is None:
                plain += self._character(quote)
            else:
                parts += [*_plain(plain), found]
                plain = ""
        self._at += len(quote)
        return [*parts, *_plain(plain)] or [TextSubstitution(text="")]

    def _character(self, quote: str) -> str:
        escaped = self._text[self._at] == "\\" and self._text[self._at + 1 : self._at + 2]
        if escaped and (escaped == "$" or (quote and escaped in ("\\", quote))):
            self._at += 1
        self._at += 1
        return self._text[self._at - 1]

    def _substitution(self) -> Substitution | None:
        match = _START.match(self._text, self._at)
        if match is None or match[1] is None:
            return None
        from launch.frontend.substitutions import substitution

        self._at = match.end()
        return substitution(match[1], self._arguments(match.start()))

    def _arguments(self, start: int) -> list[Argument]:
        arguments: list[Argument] = []
        while self._at < len(self._text):
            if self._text[self._at] == ")":
                self._at += 1
                return arguments
            arguments.append(self._argument())
            self._at = _BLANKS.match(self._text, self._at).end()  # type: ignore[union-attr]
        raise SubstitutionFailure(f"no ')' ends the substitution '{self._text[start:]}'")

    def _argument(self) -> Argument:
        quote = self._text[self._at]
        if quote in "'\"":
            self._at += 1
            return Argument(quote, self.template(quote))
        return Argument("", self._word())

    def _word(self) -> list[Substitution]:
        """Up to a space, or to the bracket that closes the substitution; brackets of its own are its own."""
        parts: list[Substitution] = []
        plain, depth = "", 0
        while self._at < len(self._text) and not self._text[self._at].isspace():
            if self._text[self._at] == ")" and depth == 0:
                break
            if (found := self._substitution()) is not None:
                parts += [*_plain(plain), found]
                plain = ""
                continue
            character = self._character("")
            depth += {"(": 1, ")": -1}.get(character, 0)
            plain += character
        return [*parts, *_plain(plain)]


def _plain(text: str) -> list[Substitution]:
    return [TextSubstitution(text=text)] if text else []
