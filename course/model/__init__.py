"""What travels between processes, into files and into reports; all other rooms build on it."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any, TypeVar

import msgspec

if TYPE_CHECKING:
    # mypy looks at the fields that are changed, of structs too.
    from dataclasses import replace as replace  # noqa: TID251 - given on from here
else:
    T = TypeVar("T")

    def replace(value: T, /, **changes: Any) -> T:
        """Return a copy of a struct or dataclass with these fields changed."""
        by = msgspec.structs.replace if isinstance(value, msgspec.Struct) else dataclasses.replace  # noqa: TID251
        return by(value, **changes)
