"""Names that are nearly right: which known name was probably meant, or how ROS would write it."""

from __future__ import annotations

import re
from collections.abc import Iterable

# `..._publisher_node` and `..._subscriber_node` are 0.84 alike, but neither is a typo of the other.
_TYPO = 0.85
# A lower bound is enough if both name the same kind of thing in the same package.
LOOSELY = 0.75
# Shorter names often differ by one letter on purpose.
_SHORT = 4


def close_names(name: str, known: Iterable[str], count: int = 3, cutoff: float = 0.6) -> tuple[str, ...]:
    """The known names most similar to `name`, best first; empty if none is similar. Ignores case."""
    import difflib  # only wrong names need it; right ones should not pay for its import

    spelling = {candidate.lower(): candidate for candidate in sorted(known)}
    return tuple(
        spelling[match] for match in difflib.get_close_matches(name.lower(), spelling, count, cutoff)
    )


def nearest(wanted: str, known: Iterable[str], cutoff: float = _TYPO) -> str | None:
    """Return the known name that `wanted` is a typo of, or None; slashes around a name do not matter."""
    plain = {candidate.strip("/"): candidate for candidate in known}
    name = wanted.strip("/")
    close = close_names(name, plain, 1, cutoff)
    if not close and len(name) > _SHORT:
        close = tuple(other for other in plain if _one_typo(name.lower(), other.lower()))
    return plain[close[0]] if close else None


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """`; did you mean ...?` as the end of a sentence, or an empty string."""
    found = close_names(name, known, 1)
    return f"; did you mean `{found[0]}`?" if found else ""


def listed(names: Iterable[str], empty: str = "none") -> str:
    """Return `a, b, and c`, each in backquotes."""
    quoted = [f"`{name}`" for name in names]
    if len(quoted) > 2:
        quoted = [f"{', '.join(quoted[:-1])},", quoted[-1]]
    return " and ".join(quoted) or empty


def counted(count: int, noun: str) -> str:
    """`1 line`, `2 lines`."""
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"


def in_one_line(text: str) -> str:
    """The text on one line, with single spaces."""
    return " ".join(text.split())


def _one_typo(one: str, other: str) -> bool:
    """Whether one letter is missing, extra or wrong, or two are swapped."""
    shared = min(len(one), len(other))
    start = next((n for n in range(shared) if one[n] != other[n]), shared)
    one, other = one[start:], other[start:]
    return (
        one[1:] == other[1:]
        or one[1:] == other
        or one == other[1:]
        or (one[:2] == other[1::-1] and one[2:] == other[2:])
    )


def snake_case(name: str) -> str:
    """`point_stamped` for `PointStamped`, as ROS writes the names of fields and headers."""
    return re.sub(r"[^a-z0-9]+", "_", re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()).strip("_")
