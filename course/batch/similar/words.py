"""Programs as sequences of words, one character each: what stays the same when names are changed.

Comments, docstrings and blanks are left out. In Python and C++ every name is the same word, and so is
every string and every number; in YAML and XML, which hold little but names and values, they stay apart.
"""

from __future__ import annotations

import time
from array import array
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import PurePosixPath
from typing import TYPE_CHECKING
from zlib import crc32

if TYPE_CHECKING:
    from pygments.token import _TokenType

# Three digits to the base of 36 for each word: that is what fingerprints are made of.
DIFFERENT = 36**3
_FIRST = 0x100
# For a text made to be slow, a lexer's time grows with the square of its length.
_LONGEST = 3.0  # seconds of this thread's own time for one file

_LANGUAGES = {
    ".py": "python",
    **dict.fromkeys((".cpp", ".hpp", ".cc", ".hh", ".cxx", ".hxx", ".c", ".h"), "cpp"),
    **dict.fromkeys((".yaml", ".yml"), "yaml"),
    ".launch": "xml",
}
_LAUNCH = (".launch.xml", "_launch.xml")
_DATA = ("yaml", "xml")


class TooSlow(Exception):
    """Reading the text would take too long."""


@dataclass(frozen=True)
class Words:
    """text: one character a word. lines: the line (from 1) of each."""

    text: str
    lines: array[int]


def language_of(path: str) -> str | None:
    """What a file is written in, by its name; None when it is not one that is compared."""
    name = PurePosixPath(path)
    return "xml" if name.name.endswith(_LAUNCH) else _LANGUAGES.get(name.suffix)


def words_of(text: str, language: str) -> Words:
    """Whatever the text says, this does not fail: what the language does not know is passed over.

    Raises TooSlow.
    """
    found: list[str] = []
    lines = array("i")
    for value, line in _values(text, language):
        found.append(chr(_FIRST + crc32(value.encode("utf-8", "replace")) % DIFFERENT))
        lines.append(line)
    return Words("".join(found), lines)


def number_of(character: str) -> int:
    """The word's number, from 0 to DIFFERENT - 1."""
    return ord(character) - _FIRST


def _values(text: str, language: str) -> Iterator[tuple[str, int]]:
    """Words with their lines. The parts of one string are one word."""
    line, at, last = 1, 0, ""
    for begin, kind, raw in _tokens(text, language):
        line += text.count("\n", at, begin)
        at = begin
        value = _word(kind, raw, language in _DATA)
        if value and not value == last == _STRING:
            yield value, line
        last = value or last


def _tokens(text: str, language: str) -> Iterator[tuple[int, _TokenType, str]]:
    from pygments.lexers import get_lexer_by_name  # only this command needs it

    latest = time.thread_time() + _LONGEST
    # A lexer knows a comment by the end of its line.
    tokens = get_lexer_by_name(language).get_tokens_unprocessed(f"{text}\n")
    for number, token in enumerate(tokens):
        if number % 16 == 0 and time.thread_time() > latest:
            raise TooSlow
        yield token


_STRING = '""'


def _word(kind: _TokenType, raw: str, data: bool) -> str:
    """ "" for what does not count."""
    first, second = (*kind, "", "")[:2]
    if first in ("Comment", "Text", "Error") or kind[2:3] == ("Doc",):
        return ""
    if data or first in ("Keyword", "Operator", "Punctuation"):
        return raw.strip()
    if second == "String":
        return _STRING
    return "0" if second == "Number" else "name" if first == "Name" else raw.strip()
