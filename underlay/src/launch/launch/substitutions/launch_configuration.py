"""The value of a launch configuration, which is what a launch argument sets."""

from __future__ import annotations

from collections.abc import Iterable

from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.substitutions.looked_up import LookedUp


class LaunchConfiguration(LookedUp):
    _shown = "LaunchConfig"
    _missing = "launch configuration '{}' does not exist"

    def __init__(self, variable_name: object, *, default: object | None = None) -> None:
        super().__init__(variable_name, None if default is None else _as_text(default))

    @property
    def variable_name(self) -> list[Substitution]:
        return self._name

    def _find(self, context: LaunchContext, name: str) -> object | None:
        found: object | None = context.launch_configurations.get(name)
        return found


def _as_text(default: object) -> object:
    """Numbers and the like are allowed as defaults."""
    if isinstance(default, str | Substitution):
        return default
    return [_as_text(item) for item in default] if isinstance(default, Iterable) else str(default)
