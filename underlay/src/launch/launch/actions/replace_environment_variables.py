"""Another environment altogether."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from launch.actions.named import Replacing
from launch.launch_context import LaunchContext


class ReplaceEnvironmentVariables(Replacing):
    def __init__(self, environment: Mapping[Any, Any] | None = None, **kwargs: Any) -> None:
        super().__init__(environment, **kwargs)

    def execute(self, context: LaunchContext) -> None:
        context._replace_environment(self._performed(context))
