"""What a Markdown text holds that can be wrong: code, links and headings, with their lines."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from itertools import pairwise

from markdown_it import MarkdownIt
from markdown_it.token import Token


@dataclass(frozen=True)
class Code:
    """A block of code, or a bit of code in a sentence. line: of its first line, from 1.

    language: as the block says it, "" where it says nothing, None for code in a sentence.
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
    """As GitHub and most other readers make them of headings."""
    for heading, inline in pairwise(tokens):
        if heading.type == "heading_open":
            yield re.sub(r"[^\w\- ]", "", inline.content.lower()).replace(" ", "-")


def _inline(tokens: list[Token]) -> Iterator[tuple[Token, int]]:
    """The parts of sentences with their lines, from 1."""
    start = 0
    for token in tokens:
        start = token.map[0] if token.map else start
        line = start + 1
        for child in token.children or ():
            yield child, line
            line += child.type in ("softbreak", "hardbreak")
