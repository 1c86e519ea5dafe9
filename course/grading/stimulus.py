"""Texts to send to a learner's node that nobody can know beforehand."""

from __future__ import annotations

import secrets

_WORDS = (
    "amber brook cedar dune ember fjord grove heath isle jetty knoll lagoon marsh north oasis pebble".split()
)


def words(count: int) -> str:
    """Return `count` random words, such as `ember511 isle40`, that cannot appear by chance."""
    return " ".join(f"{secrets.choice(_WORDS)}{secrets.randbelow(1000)}" for _ in range(count))
