"""Another environment altogether."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from launch.action import Action, texts
from launch.launch_context import LaunchContext
from launch.utilities import perform_substitutions


class ReplaceEnvironmentVariables(Action):
    def __init__(self, environment: Mapping[Any, Any] | None = None, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__environment = dict(environment or {})

    def execute(self, context: LaunchContext) -> None:
        context._replace_environment(
            {
                perform_substitutions(context, texts(name)): perform_substitutions(context, texts(value))
                for name, value in self.__environment.items()
            }
        )
