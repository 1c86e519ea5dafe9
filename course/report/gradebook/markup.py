"""Texts of a submission inside Markdown: they stay texts.

A name or a line of output must not become a link, an image, HTML, a table's border, a formula, or a
mention that sends somebody mail; neither on GitHub nor in a stricter or looser renderer.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

# Invisible, and no word goes on across it: after it, no renderer sees an address or a mention.
_BREAK = "\u2060"
_ENTITIES = {"&": "&amp;", "<": "&lt;", ">": "&gt;"}
# An underscore inside a word is no mark, and names of ROS are full of them.
_MARKS = re.compile(r"[\\`*\[\]|~$]|(?<![^\W_])_|_(?![^\W_])")
_AUTOMATIC = re.compile(
    r"(?<=@)(?=\w)|(?<=:)(?=//)|(?<=www)(?=\.)|(?<=#)(?=\d)|(?<=GH)(?=-\d)", re.IGNORECASE
)
# What would begin a list, a heading or a quotation.
_BEGINNING = re.compile(r"^(?:\d+(?=[.)])|(?=[-+#=]))")
_QUOTES = re.compile(r"`+")


def plain(text: str) -> str:
    """One line of text in which nothing means anything."""
    return _BEGINNING.sub(r"\g<0>\\", _inert(text))


def prose(text: str) -> str:
    """One line of text; what stands in `backquotes` is code, nothing else means anything."""
    parts = text.split("`")
    if len(parts) % 2 == 0 or any(not part.strip() for part in parts[1::2]):
        return plain(text)
    shown = (code(part) if odd % 2 else _inert(part) or _gap(odd, parts) for odd, part in enumerate(parts))
    return _BEGINNING.sub(r"\g<0>\\", "".join(shown))


def code(text: str) -> str:
    """One line of text as code."""
    fence = "`" * (_longest(text) + 1)
    pad = " " if text.startswith("`") or text.endswith("`") else ""
    return f"{fence}{pad}{text}{pad}{fence}".replace("\n", " ")


def fenced(lines: Iterable[str], indent: str = "") -> str:
    """Lines as a block of code that none of them can end."""
    every = [piece for line in lines for piece in line.split("\n")]
    fence = "`" * max(3, max(map(_longest, every), default=0) + 1)
    return "\n".join(f"{indent}{line}".rstrip() for line in (f"{fence}text", *every, fence))


def _inert(text: str) -> str:
    named = re.sub(r"[&<>]", lambda match: _ENTITIES[match[0]], text.replace("\n", " "))
    return _AUTOMATIC.sub(_BREAK, _MARKS.sub(r"\\\g<0>", named))


def _longest(text: str) -> int:
    return max((len(run) for run in _QUOTES.findall(text)), default=0)


def _gap(index: int, parts: list[str]) -> str:
    """Two codes side by side would be one."""
    return " " if 0 < index < len(parts) - 1 else ""
