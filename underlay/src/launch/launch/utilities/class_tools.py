"""Questions about classes."""

from __future__ import annotations

from typing import Any


def is_a(value: object, kind: type) -> bool:
    return isinstance(value, kind)


def is_a_subclass(value: Any, kind: type) -> bool:
    return isinstance(value, type) and issubclass(value, kind)
