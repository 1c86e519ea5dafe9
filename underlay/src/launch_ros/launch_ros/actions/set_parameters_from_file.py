"""A parameter file for all nodes that follow."""

from __future__ import annotations

from typing import Any

from launch.action import Action, texts
from launch.launch_context import LaunchContext
from launch.utilities import perform_substitutions


class SetParametersFromFile(Action):
    """Ends with its group."""

    def __init__(self, filename: object, node_name: object | None = None, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__filename = texts(filename)

    def execute(self, context: LaunchContext) -> None:
        before = context.launch_configurations.get("global_params", [])
        path = perform_substitutions(context, self.__filename)
        context.launch_configurations["global_params"] = [*before, path]
