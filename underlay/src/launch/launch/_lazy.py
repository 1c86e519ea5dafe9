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

    `absent` are names that the real package has and this one has not, with what to do about it: anyone who
    uses one is told so (see launch.absent).
    """

    def find(name: str) -> Any:
        if absent and name in absent:
            value = _absent(package, name, absent[name])
        elif name in names:
            value = _imported(package, name, names[name])
        else:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        setattr(sys.modules[package], name, value)
        return value

    return find


def _imported(package: str, name: str, source: str) -> Any:
    module = importlib.import_module(f"{package}.{source}")
    return module if source == name else getattr(module, name)


def _absent(package: str, name: str, instead: str) -> type:
    from launch.absent import stand_in

    return stand_in(package, name, instead)
