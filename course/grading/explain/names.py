"""Near misses: the name that was probably meant."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches

# `..._publisher_node` and `..._subscriber_node` are alike to 0.84, and not a slip.
_ALIKE = 0.85


def nearest(wanted: str, candidates: Iterable[str]) -> str | None:
    """The candidate most like `wanted`, if any is alike enough to be a slip of the keyboard."""
    plain = {candidate.lower().strip("/"): candidate for candidate in candidates}
    close = get_close_matches(wanted.lower().strip("/"), list(plain), n=1, cutoff=_ALIKE)
    return plain[close[0]] if close else None


def listed(names: Iterable[str], empty: str = "none") -> str:
    """`a, b and c`, each in backquotes."""
    quoted = [f"`{name}`" for name in names]
    if not quoted:
        return empty
    return quoted[0] if len(quoted) == 1 else f"{', '.join(quoted[:-1])} and {quoted[-1]}"
