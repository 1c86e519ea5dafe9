"""The parts of a Markdown text that can be wrong: links, headings, code, and the commands in it."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from itertools import pairwise

from markdown_it import MarkdownIt
from markdown_it.token import Token


@dataclass(frozen=True)
class Code:
    """A code block, or code in a sentence. line: the number of its first line, from 1.

    language: as given for the block, "" if it is not given, None for code in a sentence.
    """

    text: str
    line: int
    language: str | None


@dataclass(frozen=True)
class Link:
    """A link or a picture."""

    target: str
    line: int


@dataclass(frozen=True)
class Contents:
    codes: tuple[Code, ...]
    links: tuple[Link, ...]
    anchors: frozenset[str]


@cache
def contents(text: str) -> Contents:
    tokens = MarkdownIt("commonmark").enable("table").parse(text)
    return Contents(tuple(_codes(tokens)), tuple(_links(tokens)), frozenset(_anchors(tokens)))


def _codes(tokens: list[Token]) -> Iterator[Code]:
    for token in tokens:
        if token.type in ("fence", "code_block") and token.map:
            opening = 1 if token.type == "fence" else 0
            language = token.info.split()[0] if token.info.strip() else ""
            yield Code(token.content, token.map[0] + 1 + opening, language)
    for child, line in _inline(tokens):
        if child.type == "code_inline":
            yield Code(child.content, line, None)


def _links(tokens: list[Token]) -> Iterator[Link]:
    for child, line in _inline(tokens):
        target = child.attrs.get({"link_open": "href", "image": "src"}.get(child.type, ""))
        if target is not None:
            yield Link(str(target), line)


def _anchors(tokens: list[Token]) -> Iterator[str]:
    """Anchors of headings, in the form that GitHub uses."""
    for heading, inline in pairwise(tokens):
        if heading.type == "heading_open":
            yield re.sub(r"[^\w\- ]", "", inline.content.lower()).replace(" ", "-")


def _inline(tokens: list[Token]) -> Iterator[tuple[Token, int]]:
    """The inline tokens of the text, with their lines, from 1."""
    start = 0
    for token in tokens:
        start = token.map[0] if token.map else start
        line = start + 1
        for child in token.children or ():
            yield child, line
            line += child.type in ("softbreak", "hardbreak")


# Replaces `<name>`, so that the shell and the command see a word.
PLACEHOLDER = "placeholder"
# Stands for any number of words.
ANYTHING = "..."

_SHELLS = ("bash", "sh", "shell", "console", "zsh")
_NAMED_GAP = re.compile(r"<[A-Za-z][\w-]*>")
_OPTIONAL = re.compile(r"\[(-[^\[\]]*|\.\.\.)\]")
_BEFORE = frozenset("time sudo exec nohup then do else !".split())
_OPERATOR = frozenset("|&;()<>")


@dataclass(frozen=True)
class ShellCommand:
    """A command with its words. line: counted from 1 in the text.

    mentioned: it is in a sentence, so its arguments may be missing. only_name: it is in a drawing or in
    printed text, where only its first words are certain.
    """

    words: tuple[str, ...]
    line: int
    mentioned: bool = False
    only_name: bool = False


@dataclass(frozen=True)
class UnreadableLine:
    """A line that no shell can read."""

    text: str
    line: int


def commands(code: Code, program: str) -> Iterator[ShellCommand | UnreadableLine]:
    """The commands of this program in a piece of code."""
    if program not in code.text:
        return
    if code.language is None:
        for words in _split(code.text.strip()) or ():
            if words and words[0] == program:
                yield ShellCommand(words, code.line, mentioned=True)
    elif code.language in _SHELLS or _prompts(code):
        yield from _typed(code, program)
    elif code.language in ("", "text"):
        yield from _drawn(code, program)


def _prompts(code: Code) -> bool:
    return any(line.lstrip().startswith("$ ") for line in code.text.splitlines())


def _typed(code: Code, program: str) -> Iterator[ShellCommand | UnreadableLine]:
    for line, text in _whole_lines(code):
        found = _split(text)
        if found is None and program in text:
            yield UnreadableLine(text.splitlines()[0], line)
        for words in found or ():
            if words and words[0] == program:
                yield ShellCommand(words, line)


def _whole_lines(code: Code) -> Iterator[tuple[int, str]]:
    """Join each line with its continuation: after a backslash, or inside quotation marks."""
    lines, prompts = code.text.splitlines(), _prompts(code)
    start = 0
    while start < len(lines):
        if prompts and not lines[start].lstrip().startswith("$ "):
            start += 1  # output
            continue
        end = start + 1
        while end < len(lines) and lines[end - 1].endswith("\\"):
            end += 1
        end = _end_of_quotes(lines, start, end)
        text = "\n".join(lines[start:end]).strip()
        yield code.line + start, text.removeprefix("$ ")
        start = end


def _end_of_quotes(lines: list[str], start: int, end: int) -> int:
    """The position after the closing quotation mark; `end` if there is none."""
    for later in range(end, len(lines) + 1):
        if _split("\n".join(lines[start:later])) is not None:
            return later
    return end


def _split(text: str) -> tuple[tuple[str, ...], ...] | None:
    """The simple commands of a line; None if the line cannot be parsed."""
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
    """The command without variable assignments, a prompt, or words such as `time` before it."""
    for index, word in enumerate(words):
        if word not in (*_BEFORE, "$") and not re.match(r"[A-Za-z_]\w*=", word):
            return words[index:]
    return ()


def _drawn(code: Code, program: str) -> Iterator[ShellCommand]:
    """Commands in a drawing: the words up to the first gap. What follows is part of the drawing."""
    for number, text in enumerate(code.text.splitlines()):
        for match in re.finditer(rf"(?<![\w./-]){re.escape(program)}((?: [\w-]+)*)(?![\w./-])", text):
            words = (program, *match[1].split())
            yield ShellCommand(words, code.line + number, mentioned=True, only_name=True)
