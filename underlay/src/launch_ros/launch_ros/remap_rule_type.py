"""What can be written for remappings."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

SomeRemapRule = tuple[Any, Any]
SomeRemapRules = Iterable[SomeRemapRule]
