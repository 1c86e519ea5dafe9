"""Markdown as its renderers see it: what in a text would be more than text."""

from __future__ import annotations

import re
from collections.abc import Iterator

from markdown_it import MarkdownIt
from markdown_it.token import Token

HARMFUL = {"link_open", "image", "html_inline", "html_block", "s_open", "em_open", "hr", "blockquote_open"}
# What GitHub looks for in texts outside of code.
AUTOMATIC = re.compile(r"\w://\w|\bwww\.\w|[\w.+-]@\w|(?<![\w`])@\w|#\d|\bGH-\d", re.IGNORECASE | re.ASCII)


def tokens(text: str) -> list[Token]:
    reader = MarkdownIt("commonmark").enable(["table", "strikethrough"])
    return list(_flat(reader.parse(text)))


def harm(text: str) -> list[str]:
    """What is more than text in it."""
    every = tokens(text)
    found = [token.type for token in every if token.type in HARMFUL]
    found += [token.content for token in every if token.type == "text" and AUTOMATIC.search(token.content)]
    return found


def shown(text: str) -> str:
    """What a reader sees, without what is invisible."""
    parts = [token.content for token in tokens(text) if token.type in ("text", "code_inline", "fence")]
    return "".join(parts).replace("\u2060", "")


def _flat(every: list[Token]) -> Iterator[Token]:
    for token in every:
        yield token
        yield from _flat(token.children or [])
