"""Names of nodes, topics and services in answers: with a slash before them and without."""

from __future__ import annotations

from collections.abc import Mapping


def spellings(name: str) -> tuple[str, str]:
    """With a slash before it and without: both name the same."""
    return f"/{name.lstrip('/')}", name.lstrip("/")


def for_both(whys: Mapping[str, str]) -> dict[str, str]:
    """Each explanation of a wrong name, for both of its spellings."""
    return {spelling: why for name, why in whys.items() for spelling in spellings(name)}
