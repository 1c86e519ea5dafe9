"""No launch configurations, but those given here."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from launch.actions.named import Replacing
from launch.launch_context import LaunchContext


class ResetLaunchConfigurations(Replacing):
    def __init__(self, launch_configurations: Mapping[Any, Any] | None = None, **kwargs: Any) -> None:
        super().__init__(launch_configurations, **kwargs)

    def execute(self, context: LaunchContext) -> None:
        kept = self._performed(context)
        context.launch_configurations.clear()
        context.launch_configurations.update(kept)
