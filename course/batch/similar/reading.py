"""Reads the programs of one submission, bounded: what is too large, too slow or no text is left out."""

from __future__ import annotations

import hashlib
import time
from collections.abc import Iterable
from pathlib import PurePosixPath

from course.batch.similar.words import TooSlow, Words, language_of, words_of
from course.batch.similar.work import File
from course.errors import OurFault
from course.home.opening import Finding, Notes

LARGEST = 128 * 1024  # bytes of one file
MOST_FILES = 1000
MOST_WORDS = 60_000  # of one submission; the whole course's solutions have about a third of that
LONGEST = 10.0  # seconds of this thread's own time for one submission; usual are milliseconds

# Made by tools, or the same in every right submission: the answers to a quiz.
_LEFT_OUT = frozenset({"build", "install", "log", "resource", "answers", "__pycache__"})

_TOO_LARGE = f"Files larger than {LARGEST // 1024} kB were not compared."
_BINARY = "Files that are no text were not compared."
_SLOW = "Files that take too long to read were not compared."
_UNREADABLE = "Files that cannot be read were not compared."
_TOO_MUCH = "Of so much code, only a part was compared; left out are the last files by name."


class Reader:
    """Reads a class. Files with the same content are read once, however many submissions hold them."""

    def __init__(self) -> None:
        self._known: dict[tuple[str, bytes], Words | str] = {}

    def read(self, files: Iterable[File]) -> tuple[list[tuple[File, Words]], tuple[Finding, ...]]:
        """Those files that are programs, as words, and what was left out."""
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
        """Or why it was left out."""
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
    """Whatever bytes: as text with lines that end in a newline."""
    return data.decode("utf-8-sig", "replace").replace("\r\n", "\n").replace("\r", "\n")
