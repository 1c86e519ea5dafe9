"""A comparison as it is shown, and the phrases that the terminal and the page share.

Texts and names come from strangers: each is sanitized when it becomes part of a phrase.
"""

from __future__ import annotations

from dataclasses import dataclass

from course.report import sanitize

NO_VERDICT = (
    "Alike is not a verdict: look at both sides, and ask. There may be one natural way to write it, two may "
    "have worked together as they were allowed to, or both may have used the same source."
)
# If it is longer, the other lines are only counted.
_NAME = 100
_FILE = 400


@dataclass(frozen=True)
class Passage:
    """Lines `first` to `last` (from 1, both included) of a file, without their line ends."""

    file: str
    first: int
    lines: tuple[str, ...]

    @property
    def last(self) -> int:
        return self.first + len(self.lines) - 1


@dataclass(frozen=True)
class Match:
    """Passages that are the same except for names, texts, numbers, comments, and spaces."""

    one: Passage
    other: Passage


@dataclass(frozen=True)
class Side:
    """share: how much of this side's own code the other side contains (0 to 1). lines: the same in lines."""

    name: str
    share: float
    lines: int


@dataclass(frozen=True)
class Pair:
    """matches: the longest first. more: how many matches are left out."""

    one: Side
    other: Side
    matches: tuple[Match, ...]
    more: int = 0


@dataclass(frozen=True)
class Comparison:
    """pairs: similar ones, the most similar first. more: how many similar pairs are left out.

    compared: submissions with their own code. threshold: the smallest share that is shown (0 to 1).
    without: names of submissions without their own code. remarks: what was left out.
    """

    pairs: tuple[Pair, ...]
    compared: int
    threshold: float
    more: int = 0
    without: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()


def name_of(side: Side) -> str:
    return sanitize.one_line(side.name, _NAME)


def share_of(side: Side) -> str:
    """`83%, 34 lines`."""
    return f"{side.share:.0%}, {counted(side.lines, 'line')}"


def place_of(passage: Passage) -> str:
    """`src/package/node.py:3-20`."""
    return f"{sanitize.one_line(passage.file, _FILE)}:{passage.first}-{passage.last}"


def code_of(passage: Passage) -> list[tuple[int, str]]:
    """Line numbers and lines."""
    return [(number, sanitize.one_line(line)) for number, line in enumerate(passage.lines, passage.first)]


def headline(comparison: Comparison) -> str:
    found = len(comparison.pairs) + comparison.more
    share = f"{comparison.threshold:.0%}"
    pairs = "No pair is" if not found else "1 pair is" if found == 1 else f"{found} pairs are"
    compared = counted(comparison.compared, "submission")
    return f"{compared} compared. {pairs} alike: {share} or more of one's own code is in the other, too."


def more_pairs(comparison: Comparison) -> str:
    return f"{counted(comparison.more, 'more pair')} not shown here: `--most` raises the number."


def without(comparison: Comparison) -> str:
    """Whose code could not be compared; "" if there is nobody."""
    if not comparison.without:
        return ""
    names = ", ".join(sanitize.one_line(name, _NAME) for name in comparison.without[:10])
    more = len(comparison.without) - 10
    tail = f" and {more} more" if more > 0 else ""
    return f"Too little code of their own to compare, apart from what the course gives: {names}{tail}."


def counted(count: int, noun: str) -> str:
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"
