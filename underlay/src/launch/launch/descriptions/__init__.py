"""What is run, apart from how."""

from __future__ import annotations

from launch._lazy import lazily

_NAMES = {"Executable": "executable"}
__all__ = list(_NAMES)
__getattr__ = lazily(__name__, _NAMES)
