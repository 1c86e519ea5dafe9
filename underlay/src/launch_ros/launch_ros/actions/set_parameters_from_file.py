"""A parameter file for all nodes that follow."""

from __future__ import annotations

from typing import Any

from launch.action import Action, texts
from launch.launch_context import LaunchContext
from launch.utilities import perform_substitutions

from launch_ros.utilities.shared_file import SharedFile


class SetParametersFromFile(Action):
    """Ends with its group. With `node_name` it is for nodes of that name only, given alone or in full."""

    def __init__(self, filename: object, node_name: object | None = None, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__filename = texts(filename)
        self.__node_name = None if node_name is None else texts(node_name)

    def execute(self, context: LaunchContext) -> None:
        before = context.launch_configurations.get("global_params", [])
        name = None if self.__node_name is None else perform_substitutions(context, self.__node_name)
        file = SharedFile(perform_substitutions(context, self.__filename), name)
        context.launch_configurations["global_params"] = [*before, file]
