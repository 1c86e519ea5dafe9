"""When two answers are the same: texts without regard to capitals and blanks, numbers within a tolerance."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable

from course.content import Question

# A number, perhaps with its unit: `10`, `9,8 Hz`, `~ 2.5e3`.
_NUMBER = re.compile(r"[~≈]?\s*([-+]?\d{1,30}(?:[.,]\d{1,30})?(?:[eE][-+]?\d{1,3})?)\s*([^\d\s.,].{0,40})?")
_ROUNDING = 1e-9


def plain(text: str) -> str:
    """Without the backquotes of code and with single blanks."""
    return " ".join(text.replace("`", "").split())


def tidy(text: str, *, exact: bool = False) -> str:
    """What is compared: by default without regard to capitals, blanks at the ends and a final full stop."""
    return text.strip() if exact else plain(text).casefold().removesuffix(".").strip()


def same(text: str, others: Iterable[str], *, exact: bool = False) -> str | None:
    """The one of `others` that `text` means: to the letter if there is one, else loosely; or None."""
    known = tuple(others)
    for loose in (str.strip, plain, tidy):
        fits = [other for other in known if loose(other) == loose(text)]
        if fits or exact:
            return fits[0] if fits else None
    return None


def number(text: str) -> float | None:
    """The number that a learner wrote, with or without its unit; None when it is none."""
    found = _NUMBER.fullmatch(text.strip())
    value = float(found[1].replace(",", ".")) if found else math.nan
    return value if math.isfinite(value) else None


def is_near(seen: float, wanted: float, question: Question) -> bool:
    """Within the question's tolerance, taken as the same share of `wanted` as of the right value."""
    share = question.tolerance / abs(question.value) if question.value else 0.0
    width = question.tolerance if wanted == question.value else share * abs(wanted)
    return abs(seen - wanted) <= width + _ROUNDING * max(1.0, abs(wanted))


def items(texts: tuple[str, ...], wanted: tuple[str, ...]) -> tuple[str, ...]:
    """A list of answers, also when it was written as one text: `build, install and log`."""
    if len(texts) != 1:
        return texts
    blanks = r"|\s+" if not any(" " in text for text in wanted) else ""
    parts = re.split(rf"\s*[,;\n]\s*(?:and\s+)?|\s+and\s+{blanks}", texts[0].strip())
    return tuple(part for part in parts if part)
