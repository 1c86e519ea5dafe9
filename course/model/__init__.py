"""Data that travels between processes, into files, and into reports; everything else builds on it."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any, TypeVar

import msgspec

if TYPE_CHECKING:
    # With this, mypy checks the fields that are changed, even those of structs.
    from dataclasses import replace as replace  # noqa: TID251 - exported from here
else:
    T = TypeVar("T")

    def replace(value: T, /, **changes: Any) -> T:
        """Return a copy of a struct or dataclass with these fields changed."""
        by = msgspec.structs.replace if isinstance(value, msgspec.Struct) else dataclasses.replace  # noqa: TID251
        return by(value, **changes)
