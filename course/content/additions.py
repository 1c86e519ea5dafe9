"""Files of the home that a solution only adds to: `.bashrc` is the learner's own, and holds more."""

from __future__ import annotations

ADDED_TO = frozenset({".bashrc"})


def with_addition(text: str, addition: str) -> str:
    """`text` with `addition` as its last lines; unchanged when it holds them already."""
    if addition.strip() in text:
        return text
    return f"{text.rstrip()}\n\n{addition}" if text.strip() else addition
