"""The commands of a CMakeLists.txt, read as far as the learner's own lines go: nothing is carried out."""

from __future__ import annotations

import re
from dataclasses import dataclass

from course.evidence.sources import Sources
from course.feedback import Location

LISTS = "CMakeLists.txt"
_COMMAND = re.compile(r"^[ \t]*(?P<name>[A-Za-z_]\w*)[ \t]*\(", re.MULTILINE)
# A quoted text, a comment, a bracket, or a word.
_TOKEN = re.compile(r'"(?P<quoted>(?:\\.|[^"\\])*)"|#[^\n]*|(?P<bracket>[()])|(?P<word>[^\s()"#]+)')
_VARIABLE = re.compile(r"\$\{(\w+)\}")


@dataclass(frozen=True)
class Command:
    """`install(TARGETS node DESTINATION lib/talk)`: name in small letters, variables put in where known."""

    name: str
    words: tuple[str, ...]
    where: Location

    def after(self, keyword: str) -> str | None:
        """The word behind this one."""
        pairs = zip(self.words, self.words[1:], strict=False)
        return next((value for word, value in pairs if word == keyword), None)


def commands(sources: Sources, folder: str) -> tuple[Command, ...]:
    """Of the package in this folder, in their order; none without the file."""
    file = f"{folder}/{LISTS}"
    text = sources.files.get(file, "")
    found: list[Command] = []
    known: dict[str, str] = {}
    position = 0
    while match := _COMMAND.search(text, position):
        words, position = _words(text, match.end(), known)
        line = text.count("\n", 0, match.start("name")) + 1
        command = Command(match["name"].lower(), words, Location(file, line))
        if command.name == "project" and words:
            known["PROJECT_NAME"] = words[0]
        if command.name == "set" and len(words) > 1:
            known[words[0]] = words[1]
        found.append(command)
    return tuple(found)


def _words(text: str, start: int, known: dict[str, str]) -> tuple[tuple[str, ...], int]:
    """The words up to the bracket that closes the command, and the place behind it."""
    words: list[str] = []
    depth = 1
    for token in _TOKEN.finditer(text, start):
        if token["bracket"]:
            depth += 1 if token["bracket"] == "(" else -1
            if depth == 0:
                return tuple(words), token.end()
        elif token["word"] or token["quoted"] is not None:
            plain = token["word"] or token["quoted"]
            words.append(_VARIABLE.sub(lambda name: known.get(name[1], name[0]), plain))
    return tuple(words), len(text)
