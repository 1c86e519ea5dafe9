"""Reading CMake: the commands of a CMakeLists.txt, and the errors that CMake prints."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from course.evidence.sources import Sources
from course.explain.engine import Evidence, Symptom
from course.model.feedback import Location

LISTS = "CMakeLists.txt"
_COMMAND = re.compile(r"^[ \t]*(?P<name>[A-Za-z_]\w*)[ \t]*\(", re.MULTILINE)
# A quoted text, a comment, a bracket, or a word. An unclosed text extends to the end.
_TOKEN = re.compile(r'"(?P<quoted>(?:\\.|[^"\\])*)(?:"|\\?\Z)|#[^\n]*|(?P<bracket>[()])|(?P<word>[^\s()"#]+)')
_VARIABLE = re.compile(r"\$\{(\w+)\}")
# Limit for a variable's value, in characters: a few dozen lines that each double it would fill any memory.
_LONGEST_VALUE = 200

_LONGEST = 160  # characters of CMake's own words in a summary
# Limits for errors, and for words in one of them, because a log may contain endless forged ones.
_MOST_ERRORS, _MOST_LINES, _LONGEST_TEXT = 50, 100, 4000
_HEAD = re.compile(
    r"^CMake Error(?: at (?P<file>.+?):(?P<line>\d+)(?: \((?P<command>\w+)\))?| in (?P<list>\S+?))?:"
    r"\s?(?P<rest>.*)$"
)
_FRAME = re.compile(r"^\s+(?P<file>.+?):(?P<line>\d+) \((?P<command>\w+)\)$")


@dataclass(frozen=True)
class Command:
    """A command: `install(TARGETS node DESTINATION lib/talk)`; lowercase name, known variables expanded."""

    name: str
    words: tuple[str, ...]
    where: Location

    def after(self, keyword: str) -> str | None:
        """Return the word that follows this keyword; None if there is none."""
        pairs = zip(self.words, self.words[1:], strict=False)
        return next((value for word, value in pairs if word == keyword), None)


def commands(sources: Sources, folder: str, *names: str, first: str = "") -> tuple[Command, ...]:
    """Return the commands of the CMakeLists.txt in this folder, in order. Nothing is executed.

    names: only these commands. first: only those with this first word.
    """
    every = commands_in(sources.files.get(f"{folder}/{LISTS}", ""), f"{folder}/{LISTS}")
    return tuple(
        one for one in every if (not names or one.name in names) and (not first or one.words[:1] == (first,))
    )


def commands_in(text: str, file: str) -> list[Command]:
    found: list[Command] = []
    known: dict[str, str] = {}
    position = 0
    while match := _COMMAND.search(text, position):
        words, position = _words(text, match.end(), known)
        line = text.count("\n", 0, match.start("name")) + 1
        command = Command(match["name"].lower(), words, Location(file, line))
        given = ("PROJECT_NAME", *words) if command.name == "project" else words
        if command.name in ("project", "set") and len(given) > 1 and len(given[1]) <= _LONGEST_VALUE:
            known[given[0]] = given[1]
        found.append(command)
    return found


def _words(text: str, start: int, known: dict[str, str]) -> tuple[tuple[str, ...], int]:
    """The words up to the closing bracket of the command, and the position after it."""
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


def cmake_errors(lines: Sequence[str], evidence: Evidence) -> list[Symptom]:
    """The errors in CMake's output, in order, each with the learner's line that led to it.

    Without such a line, the place is their CMakeLists.txt. Words: `file`, and `line` if known.
    """
    heads = [number for number, line in enumerate(lines) if _HEAD.match(line)][:_MOST_ERRORS]
    return [_error(lines[start : start + _MOST_LINES], evidence) for start in heads]


def _error(lines: Sequence[str], evidence: Evidence) -> Symptom:
    head = _HEAD.match(lines[0])
    assert head is not None
    body = list(lines[1:3]) if head["rest"].endswith("NOTFOUND.") else _indented(lines[1:])
    calls = lines[1 + len(body) :]
    frames = [head, *(found for line in _indented(calls[1:]) if (found := _FRAME.match(line)))]
    text = re.sub(r"\s+", " ", " ".join((head["rest"], *body))).strip()[:_LONGEST_TEXT]
    printed = tuple(line.strip() for line in (head["rest"], *body) if line.strip())
    own = next(((file, f["line"]) for f in frames if (file := evidence.own_file(f["file"] or ""))), None)
    if own is None:
        file = head["list"] or LISTS
        return Symptom(text, evidence.place(file), printed, {"file": file})
    return Symptom(text, evidence.place(own[0], int(own[1])), printed, {"file": own[0], "line": own[1]})


def _indented(lines: Sequence[str]) -> list[str]:
    body: list[str] = []
    for line in lines:
        if line and not line.startswith("  "):
            break
        body.append(line)
    return body


def first_sentence(error: Symptom) -> str:
    """The first sentence of CMake's message, without the period."""
    return re.split(r"(?<=[.!?:])\s", error.text, maxsplit=1)[0].rstrip(".:")[:_LONGEST]
