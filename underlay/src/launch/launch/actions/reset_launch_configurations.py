"""No launch configurations, but those given here."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from launch.action import Action, texts
from launch.launch_context import LaunchContext
from launch.utilities import perform_substitutions


class ResetLaunchConfigurations(Action):
    def __init__(self, launch_configurations: Mapping[Any, Any] | None = None, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__configurations = dict(launch_configurations or {})

    def execute(self, context: LaunchContext) -> None:
        kept = {
            perform_substitutions(context, texts(name)): perform_substitutions(context, texts(value))
            for name, value in self.__configurations.items()
        }
        context.launch_configurations.clear()
        context.launch_configurations.update(kept)
