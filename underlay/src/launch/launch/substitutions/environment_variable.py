"""The value of an environment variable."""

from __future__ import annotations

from launch.launch_context import LaunchContext
from launch.substitutions.looked_up import LookedUp


class EnvironmentVariable(LookedUp):
    _shown = "EnvVar"
    _missing = "environment variable '{}' does not exist"

    def __init__(self, name: object, *, default_value: object | None = None) -> None:
        super().__init__(name, default_value)

    def _find(self, context: LaunchContext, name: str) -> str | None:
        return context.environment.get(name)
