"""Which known name a misspelt one was probably meant to be."""

from __future__ import annotations

from collections.abc import Iterable


def nearest(name: str, known: Iterable[str], count: int = 3) -> tuple[str, ...]:
    """The known names most like `name`, best first; none when nothing is alike."""
    import difflib  # only wrong names need it; right ones should not pay for its import

    spelling = {candidate.lower(): candidate for candidate in known}
    return tuple(spelling[match] for match in difflib.get_close_matches(name.lower(), spelling, count))


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """`; did you mean ...?` to end a sentence with, or nothing."""
    found = nearest(name, known, 1)
    return f"; did you mean `{found[0]}`?" if found else ""
