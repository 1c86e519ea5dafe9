"""Things to say to a learner's node that nobody can know beforehand."""

from __future__ import annotations

import secrets
from typing import Any

_WORDS = (
    "amber brook cedar dune ember fjord grove heath isle jetty knoll lagoon marsh north oasis pebble".split()
)
_LONG = 60


def quotes_to_say() -> list[dict[str, Any]]:
    """Six AmazingQuotes as dicts: plain, unicode, quotes within quotes, empty, long, plain.

    The texts are random, so that a node can only have them from the message; ids have five
    digits, by turns odd and even.
    """
    texts = [
        words(4),
        f"{words(2)} häufig – çà et là, 日本語 ✓ {words(1)}",
        f"{words(1)} said: \"{words(2)} 'and' {words(1)}\"",
        "",
        words(_LONG),
        words(5),
    ]
    start = 10_000 + secrets.randbelow(80_000)
    return [
        {"id": start + 7 * index, "quote": text, "philosopher_name": f"Professor {words(1)} {words(1)}"}
        for index, text in enumerate(texts)
    ]


def quotes_about_life() -> list[dict[str, Any]]:
    """Nine AmazingQuotes: five hold the word life, in any case; of the others two say the same."""
    same = words(4)
    texts = [
        f"{words(2)} that is life",
        same,
        f"Life {words(3)}",
        "",
        f"{words(2)} THE MEANING OF LIFE",
        same,
        f"{words(1)} of a lifetime {words(1)}",
        f"{words(2)} «häufig», 日本語",
        f"{words(2)} liFE, {words(1)}",
    ]
    start = 10_000 + secrets.randbelow(80_000)
    return [
        {"id": start + index, "quote": text, "philosopher_name": f"Professor {words(1)}"}
        for index, text in enumerate(texts)
    ]


class Oracle:
    """Answers each WhatIsThePoint with a point that nobody knows, and remembers what was asked and given.

    about_life: which kinds of quote were asked. given: the digits of each point's x, y and z; the numbers
    are whole, so that every way to write a float shows them.
    """

    def __init__(self) -> None:
        self.about_life: set[bool] = set()
        self.given: list[tuple[str, ...]] = []

    def __call__(self, request: Any) -> dict[str, Any]:
        numbers = [1000 + secrets.randbelow(9000) for _ in "xyz"]
        self.about_life.add("life" in request.quote.quote.lower())
        self.given.append(tuple(map(str, numbers)))
        return {"point": dict(zip("xyz", map(float, numbers), strict=True))}


def words(count: int) -> str:
    """So many words, such as `ember511 isle40`, that nobody says by chance."""
    return " ".join(f"{secrets.choice(_WORDS)}{secrets.randbelow(1000)}" for _ in range(count))
