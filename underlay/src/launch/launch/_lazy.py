"""Names of a package that are imported when they are first asked for: a launch file uses few of many."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Callable, Mapping
from typing import Any


def lazily(
    package: str, names: Mapping[str, str], absent: Mapping[str, str] | None = None
) -> Callable[[str], Any]:
    """The `__getattr__` of a package: `names` maps a name to the module (below the package) that has it.

    `absent` are names that the real package has and this one has not, with what to do about it: whoever
    imports one is told so, and not that it never existed.
    """

    def find(name: str) -> Any:
        if absent and name in absent:
            raise ImportError(f"{package}.{name} is not offered here: {absent[name]}")
        if name not in names:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        module = importlib.import_module(f"{package}.{names[name]}")
        value = module if names[name] == name else getattr(module, name)
        setattr(sys.modules[package], name, value)
        return value

    return find
