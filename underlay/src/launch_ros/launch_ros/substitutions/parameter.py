"""The value of a parameter that SetParameter has set."""

from __future__ import annotations

from launch.launch_context import LaunchContext
from launch.substitutions.looked_up import LookedUp


class Parameter(LookedUp):
    _missing = "parameter '{}' not found"

    def __init__(self, name: object, *, default: object | None = None) -> None:
        super().__init__(name, default)

    def _find(self, context: LaunchContext, name: str) -> object | None:
        for entry in reversed(context.launch_configurations.get("global_params", [])):
            if isinstance(entry, tuple) and entry[0] == name:
                value: object = entry[1]
                return value
        return None
