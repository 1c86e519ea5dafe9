"""A readable refusal of an argument of the wrong type."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any


def ensure_argument_type(
    argument: object, types: type | Iterable[type], argument_name: str, caller: str | None = None
) -> None:
    """Raise TypeError unless `argument` is of one of the types."""
    allowed: Any = types if isinstance(types, type) else tuple(types)
    if isinstance(argument, allowed):
        return
    where = f"{caller} " if caller else ""
    raise TypeError(
        f"{where}expected '{argument_name}' to be one of '{types}', "
        f"but got '{argument}' of type '{type(argument)}'"
    )
