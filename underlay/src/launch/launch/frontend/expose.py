"""Tags and substitutions that other packages bring along, by decorators on their classes.

What is exposed is known to the whole process, as imported modules are.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

_Kind = TypeVar("_Kind", bound=Callable[..., Any])
action_parsers: dict[str, Callable[..., Any]] = {}
substitution_parsers: dict[str, Callable[..., Any]] = {}


def expose_action(name: str) -> Callable[[_Kind], _Kind]:
    """For a class with `parse(entity, parser)`, or such a function: it gives the class and its arguments."""
    return _exposed(name, action_parsers)


def expose_substitution(name: str) -> Callable[[_Kind], _Kind]:
    """For a class with `parse(data)`: it gives the class and its arguments."""
    return _exposed(name, substitution_parsers)


def _exposed(name: str, parsers: dict[str, Callable[..., Any]]) -> Callable[[_Kind], _Kind]:
    def expose(exposed: _Kind) -> _Kind:
        parsers[name] = getattr(exposed, "parse", exposed)
        return exposed

    return expose


def load_extensions() -> None:
    """Import what installed packages expose; theirs are entry points."""
    from importlib.metadata import entry_points

    for each in entry_points(group="launch.frontend.launch_extension"):
        each.load()
