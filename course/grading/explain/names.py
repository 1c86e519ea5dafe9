"""Near misses: the name that was probably meant."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches

# `..._publisher_node` and `..._subscriber_node` are alike to 0.84, and not a slip.
_ALIKE = 0.85
# Shorter names differ by one letter and are meant to.
_SHORT = 4


def nearest(wanted: str, candidates: Iterable[str]) -> str | None:
    """The candidate most like `wanted`, if any is alike enough to be a slip of the keyboard."""
    plain = {candidate.lower().strip("/"): candidate for candidate in candidates}
    name = wanted.lower().strip("/")
    close = get_close_matches(name, list(plain), n=1, cutoff=_ALIKE)
    close = close or [other for other in plain if len(name) > _SHORT and _one_slip(name, other)]
    return plain[close[0]] if close else None


def _one_slip(one: str, other: str) -> bool:
    """One letter too many, too few or wrong, or two in the wrong order: in short names that is much."""
    shared = min(len(one), len(other))
    start = next((n for n in range(shared) if one[n] != other[n]), shared)
    one, other = one[start:], other[start:]
    return (
        one[1:] == other[1:]
        or one[1:] == other
        or one == other[1:]
        or (one[:2] == other[1::-1] and one[2:] == other[2:])
    )


def listed(names: Iterable[str], empty: str = "none") -> str:
    """`a, b and c`, each in backquotes."""
    quoted = [f"`{name}`" for name in names]
    if not quoted:
        return empty
    return quoted[0] if len(quoted) == 1 else f"{', '.join(quoted[:-1])} and {quoted[-1]}"
