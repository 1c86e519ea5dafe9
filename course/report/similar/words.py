"""The words that the terminal and the page share; each text of a submission is made harmless here."""

from __future__ import annotations

from course.report import safe
from course.report.similar.model import Comparison, Passage, Side

NO_VERDICT = (
    "Alike is no verdict: look at both sides, and ask. There may be one natural way to write it, two may "
    "have worked together as they were allowed to, or both may have used the same source."
)
# Of one that is longer, the rest is counted.
_NAME = 100
_FILE = 400


def name_of(side: Side) -> str:
    return safe.one_line(side.name, _NAME)


def share_of(side: Side) -> str:
    """`83 %, 34 lines`."""
    return f"{side.share:.0%}".replace("%", " %") + f", {counted(side.lines, 'line')}"


def place_of(passage: Passage) -> str:
    """`src/package/node.py:3-20`."""
    return f"{safe.one_line(passage.file, _FILE)}:{passage.first}-{passage.last}"


def code_of(passage: Passage) -> list[tuple[int, str]]:
    """Line numbers and lines."""
    return [(number, safe.one_line(line)) for number, line in enumerate(passage.lines, passage.first)]


def headline(comparison: Comparison) -> str:
    found = len(comparison.pairs) + comparison.more
    share = f"{comparison.threshold:.0%}".replace("%", " %")
    pairs = "No pair is" if not found else "1 pair is" if found == 1 else f"{found} pairs are"
    compared = counted(comparison.compared, "submission")
    return f"{compared} compared. {pairs} alike: {share} or more of one's own code is in the other, too."


def more_pairs(comparison: Comparison) -> str:
    return f"{counted(comparison.more, 'more pair')} not shown here: `--most` raises the number."


def without(comparison: Comparison) -> str:
    """Whose code could not be compared; "" when there is nobody."""
    if not comparison.without:
        return ""
    names = ", ".join(safe.one_line(name, _NAME) for name in comparison.without[:10])
    more = len(comparison.without) - 10
    tail = f" and {more} more" if more > 0 else ""
    return f"Too little code of their own to compare, beside what the course gives: {names}{tail}."


def counted(count: int, noun: str) -> str:
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"
