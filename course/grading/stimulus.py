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
        _words(4),
        f"{_words(2)} häufig – çà et là, 日本語 ✓ {_words(1)}",
        f"{_words(1)} said: \"{_words(2)} 'and' {_words(1)}\"",
        "",
        _words(_LONG),
        _words(5),
    ]
    start = 10_000 + secrets.randbelow(80_000)
    return [
        {"id": start + 7 * index, "quote": text, "philosopher_name": f"Professor {_words(1)} {_words(1)}"}
        for index, text in enumerate(texts)
    ]


def _words(count: int) -> str:
    return " ".join(f"{secrets.choice(_WORDS)}{secrets.randbelow(1000)}" for _ in range(count))
