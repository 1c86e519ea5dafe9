"""The commands that code in a text shows: what a shell would make of it, placeholders included."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator
from dataclasses import dataclass

from course.validate.texts.markdown import Code

# Stands for `<name>`: a word, as far as the shell and the command can tell.
PLACEHOLDER = "placeholder"
# Stands for any number of words.
ANYTHING = "..."

_SHELLS = ("bash", "sh", "shell", "console", "zsh")
_NAMED_GAP = re.compile(r"<[A-Za-z][\w-]*>")
_OPTIONAL = re.compile(r"\[(-[^\[\]]*|\.\.\.)\]")
_BEFORE = frozenset("time sudo exec nohup then do else !".split())
_OPERATOR = frozenset("|&;()<>")


@dataclass(frozen=True)
class Command:
    """A command with its words. line: counted from 1 in the text.

    mentioned: it is named rather than typed, so its arguments may be missing; only_name: it stands in a
    drawing or in printed text, where nothing but its first words can be told.
    """

    words: tuple[str, ...]
    line: int
    mentioned: bool = False
    only_name: bool = False


@dataclass(frozen=True)
class Unreadable:
    """A line that no shell can read."""

    text: str
    line: int


def commands(code: Code, program: str) -> Iterator[Command | Unreadable]:
    """The commands of this program in a piece of code."""
    if program not in code.text:
        return
    if code.language is None:
        for words in _split(code.text.strip()) or ():
            if words and words[0] == program:
                yield Command(words, code.line, mentioned=True)
    elif code.language in _SHELLS or _prompts(code):
        yield from _typed(code, program)
    elif code.language in ("", "text"):
        yield from _drawn(code, program)


def _prompts(code: Code) -> bool:
    return any(line.lstrip().startswith("$ ") for line in code.text.splitlines())


def _typed(code: Code, program: str) -> Iterator[Command | Unreadable]:
    for line, text in _whole_lines(code):
        found = _split(text)
        if found is None and program in text:
            yield Unreadable(text.splitlines()[0], line)
        for words in found or ():
            if words and words[0] == program:
                yield Command(words, line)


def _whole_lines(code: Code) -> Iterator[tuple[int, str]]:
    """Each line with those that continue it: after a backslash, or inside of quotation marks."""
    lines, prompts = code.text.splitlines(), _prompts(code)
    start = 0
    while start < len(lines):
        if prompts and not lines[start].lstrip().startswith("$ "):
            start += 1  # what was printed
            continue
        end = start + 1
        while end < len(lines) and lines[end - 1].endswith("\\"):
            end += 1
        end = _end_of_quotes(lines, start, end)
        text = "\n".join(lines[start:end]).strip()
        yield code.line + start, text.removeprefix("$ ")
        start = end


def _end_of_quotes(lines: list[str], start: int, end: int) -> int:
    """Where the quotation marks are closed; `end` when they never are."""
    for later in range(end, len(lines) + 1):
        if _split("\n".join(lines[start:later])) is not None:
            return later
    return end


def _split(text: str) -> tuple[tuple[str, ...], ...] | None:
    """The simple commands of a line; None when it cannot be read."""
    plain = _OPTIONAL.sub("", _NAMED_GAP.sub(PLACEHOLDER, text.replace("\\\n", " ").replace("…", ANYTHING)))
    words = shlex.shlex(plain, posix=True, punctuation_chars=True)
    words.whitespace_split = True
    try:
        return tuple(map(_without_prefix, _simple_commands(list(words))))
    except ValueError:
        return None


def _simple_commands(words: list[str]) -> Iterator[tuple[str, ...]]:
    command: list[str] = []
    skip = False
    for word in words:
        if set(word) <= _OPERATOR and word:
            skip = word[0] in "<>" or word == ">&"
            if not skip:
                yield tuple(command)
                command = []
            elif command and re.fullmatch(r"[0-2]", command[-1]):
                command.pop()  # the 2 of `2>`
        elif skip:
            skip = False  # the file of a redirection
        else:
            command.append(word)
    yield tuple(command)


def _without_prefix(words: tuple[str, ...]) -> tuple[str, ...]:
    """Without what may stand before a command: settings, a prompt, `time`."""
    for index, word in enumerate(words):
        if word not in (*_BEFORE, "$") and not re.match(r"[A-Za-z_]\w*=", word):
            return words[index:]
    return ()


def _drawn(code: Code, program: str) -> Iterator[Command]:
    """Words up to the first gap: what follows belongs to the drawing."""
    for number, text in enumerate(code.text.splitlines()):
        for match in re.finditer(rf"(?<![\w./-]){re.escape(program)}((?: [\w-]+)*)(?![\w./-])", text):
            words = (program, *match[1].split())
            yield Command(words, code.line + number, mentioned=True, only_name=True)
