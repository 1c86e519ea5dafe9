"""Programs as sequences of words, one character each, which stay the same when names change.

Comments, docstrings, and spaces are left out. In Python and C++, all names are the same word, and so are all
strings and all numbers. In YAML and XML, which contain little else, they remain different words.
"""

from __future__ import annotations

import hashlib
import time
from array import array
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING
from zlib import crc32

from course.errors import OurFault
from course.home.opening import Notes, Remark

if TYPE_CHECKING:
    from pygments.token import _TokenType

# Fingerprints are made from three digits in base 36 for each word.
DIFFERENT = 36**3
_FIRST = 0x100
# On a malicious text, a lexer's time grows with the square of its length.
_LONGEST = 3.0  # seconds of this thread's own time for one file

_LANGUAGES = {
    ".py": "python",
    **dict.fromkeys((".cpp", ".hpp", ".cc", ".hh", ".cxx", ".hxx", ".c", ".h"), "cpp"),
    **dict.fromkeys((".yaml", ".yml"), "yaml"),
    ".launch": "xml",
}
_LAUNCH = (".launch.xml", "_launch.xml")
_DATA = ("yaml", "xml")


@dataclass(frozen=True)
class File:
    """name: where it is in the submission. path: where it can be read."""

    name: str
    path: Path


class TooSlow(Exception):
    """Reading the text would take too long."""


@dataclass(frozen=True)
class Words:
    """text: one character a word. lines: the line (from 1) of each."""

    text: str
    lines: array[int]


def language_of(path: str) -> str | None:
    """A file's language, by its name; None if such files are not compared."""
    name = PurePosixPath(path)
    return "xml" if name.name.endswith(_LAUNCH) else _LANGUAGES.get(name.suffix)


def words_of(text: str, language: str) -> Words:
    """Works for any text, because it skips what is not valid in the language. Raises TooSlow."""
    found: list[str] = []
    lines = array("i")
    for value, line in _values(text, language):
        found.append(chr(_FIRST + crc32(value.encode("utf-8", "replace")) % DIFFERENT))
        lines.append(line)
    return Words("".join(found), lines)


def code_of(files: Mapping[str, str]) -> str:
    """By path: the same for programs that differ only in names, comments and spaces; "" without programs.

    Unlike for `words_of`, texts and numbers are different words: a comment may be about them.
    """
    found: list[str] = []
    for path, text in sorted(files.items()):
        if language := language_of(path):
            try:
                tokens = [(kind, raw) for _, kind, raw in _tokens(text, language)]
            except TooSlow:
                return ""
            literal = language in _DATA
            words = [_word(kind, raw, literal or "Literal" in kind[:1]) for kind, raw in tokens]
            found += path, *filter(None, words)
    return hashlib.blake2b("\0".join(found).encode("utf-8", "replace")).hexdigest() if found else ""


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
    # A lexer finds a comment by the end of its line.
    tokens = get_lexer_by_name(language).get_tokens_unprocessed(f"{text}\n")
    for number, token in enumerate(tokens):
        if number % 16 == 0 and time.thread_time() > latest:
            raise TooSlow
        yield token


_STRING = '""'


def _word(kind: _TokenType, raw: str, data: bool) -> str:
    """The word for a token; "" for anything that does not count."""
    first, second = (*kind, "", "")[:2]
    if first in ("Comment", "Text", "Error") or kind[2:3] == ("Doc",):
        return ""
    if data or first in ("Keyword", "Operator", "Punctuation"):
        return raw.strip()
    if second == "String":
        return _STRING
    return "0" if second == "Number" else "name" if first == "Name" else raw.strip()


LARGEST = 128 * 1024  # bytes of one file
MOST_FILES = 1000
MOST_WORDS = 60_000  # of one submission; the whole course's solutions have about a third of that
LONGEST = 10.0  # seconds of this thread's own time for one submission; usually it takes milliseconds

# Made by tools, or the same in every right submission, such as the answers to a quiz.
_LEFT_OUT = frozenset({"build", "install", "log", "resource", "answers", "__pycache__"})

_TOO_LARGE = f"Files larger than {LARGEST // 1024} kB were not compared."
_BINARY = "Files that are not text were not compared."
_SLOW = "Files that take too long to read were not compared."
_UNREADABLE = "Files that cannot be read were not compared."
_TOO_MUCH = "There is so much code that only a part was compared; the last files by name were left out."


class Reader:
    """Reads a class. Files with the same content are read once, however many submissions contain them."""

    def __init__(self) -> None:
        self._known: dict[tuple[str, bytes], Words | str] = {}

    def read(self, files: Iterable[File]) -> tuple[list[tuple[File, Words]], tuple[Remark, ...]]:
        """The programs as words, and what was left out."""
        notes = Notes()
        found: list[tuple[File, Words]] = []
        room, latest = MOST_WORDS, time.thread_time() + LONGEST
        for file in sorted(filter(is_program, files), key=lambda file: file.name):
            too_much = len(found) == MOST_FILES or time.thread_time() > latest
            words = _TOO_MUCH if too_much else self._words(file)
            if isinstance(words, Words) and len(words.text) > room:
                words = _TOO_MUCH
            if isinstance(words, str):
                notes.add(words, file.name)
            else:
                room -= len(words.text)
                found.append((file, words))
        return found, notes.findings()

    def _words(self, file: File) -> Words | str:
        """The words, or why the file was left out."""
        try:
            with file.path.open("rb") as stream:
                data = stream.read(LARGEST + 1)
        except OSError:
            return _UNREADABLE
        language = language_of(file.name)
        if language is None:
            raise OurFault(f"{PurePosixPath(file.name).name} is not written in a language that is compared")
        key = language, hashlib.blake2b(data, digest_size=16).digest()
        if key not in self._known:
            self._known[key] = _read(data, language)
        return self._known[key]


def is_program(file: File) -> bool:
    parts = PurePosixPath(file.name).parts
    hidden = any(part.startswith(".") for part in parts)
    return not hidden and _LEFT_OUT.isdisjoint(parts[:-1]) and language_of(file.name) is not None


def _read(data: bytes, language: str) -> Words | str:
    if len(data) > LARGEST:
        return _TOO_LARGE
    if b"\0" in data:
        return _BINARY
    try:
        return words_of(text_of(data), language)
    except TooSlow:
        return _SLOW


def text_of(data: bytes) -> str:
    """Any bytes as text with lines that end in a newline."""
    return data.decode("utf-8-sig", "replace").replace("\r\n", "\n").replace("\r", "\n")
