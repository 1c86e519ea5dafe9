"""Makes text from a submission harmless on a terminal, and short enough to read.

Escape sequences are removed (a log line may be colored; that is not evidence). Other control characters
are made visible. Overlong lines and lists are cut, with a count of what is missing.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

LINE_LIMIT = 240
DETAIL_LIMIT = 40

# CSI (colors, cursor), strings up to BEL or ST (titles, links, clipboard), then any other
# two-byte escape. The strings also end at the end of a line, so that an unfinished one
# removes no more than its line.
_ESCAPES = re.compile(
    r"(?:\x1b\[|\x9b)[0-?]*[ -/]*[@-~]?"
    r"|(?:\x1b[\]PX^_]|[\x90\x98\x9d-\x9f])[^\x07\x1b\x9c\n]*(?:\x07|\x1b\\|\x9c)?"
    r"|\x1b[ -/]*[0-~]?"
)
# Control characters. Line and paragraph separators. Marks that change the reading direction,
# which can make one text look like another. Halves of surrogate pairs, which no terminal's
# encoding can write.
_CONTROLS = re.compile(
    r"[\x00-\x08\x0b-\x1f\x7f-\x9f]|[\u2028\u2029]|[\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069]|[\ud800-\udfff]"
)


def clean(text: str) -> str:
    """`text` without escape sequences, with tabs as spaces and controls made visible; newlines stay."""
    text = text.replace("\r\n", "\n").expandtabs(4)
    return _CONTROLS.sub(_visible, _ESCAPES.sub("", text))


def one_line(text: str, limit: int = LINE_LIMIT) -> str:
    r"""`text` cleaned, on one line (a newline shows as \n) and cut after `limit` characters."""
    return cut(clean(text[: limit * 8].replace("\n", "\\n")), limit, len(text))


def paragraph(text: str, limit: int = 1000) -> str:
    """`text` cleaned for prose: runs of spaces and newlines become one space; cut after `limit`."""
    return cut(" ".join(clean(text[: limit * 8]).split()), limit, len(text))


def details(lines: Iterable[str], *, limit: int = LINE_LIMIT, most: int = DETAIL_LIMIT) -> list[str]:
    """Lines of evidence, each cleaned and cut, without the middle of a very long list.

    The first and the last lines stay, because a log says most at its ends.
    """
    every = [piece for line in lines for piece in line.replace("\r\n", "\n").rstrip("\n").split("\n")]
    shown = [one_line(line, limit).rstrip() for line in _ends(every, most)]
    left_out = len(every) - len(shown)
    if left_out > 0:
        shown.insert(most // 2, f"... {left_out} more lines ...")
    return shown


def cut(text: str, limit: int, length: int | None = None) -> str:
    """At most `limit` characters of `text`, then how many are missing of the original `length`."""
    if len(text) <= limit:
        return text
    return f"{text[:limit]}... ({max(length or 0, len(text)) - limit} more characters)"


def _ends(lines: list[str], most: int) -> list[str]:
    if len(lines) <= most:
        return lines
    return lines[: most // 2] + lines[-(most - most // 2) :]


def _visible(match: re.Match[str]) -> str:
    return match[0].encode("unicode_escape").decode("ascii")
