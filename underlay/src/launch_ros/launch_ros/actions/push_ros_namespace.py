"""A namespace for the nodes that follow."""

from __future__ import annotations

from typing import Any

from launch.action import Action, texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.utilities import perform_substitutions

from launch_ros.utilities.names import absolute_namespace, joined_namespace


class PushROSNamespace(Action):
    """Adds to the one that is there; a name with a slash in front replaces it. Ends with its group."""

    def __init__(self, namespace: object, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__namespace = texts(namespace)

    @property
    def namespace(self) -> list[Substitution]:
        return self.__namespace

    def execute(self, context: LaunchContext) -> None:
        before = context.launch_configurations.get("ros_namespace")
        after = joined_namespace(before, perform_substitutions(context, self.__namespace))
        if after is not None:
            context.launch_configurations["ros_namespace"] = absolute_namespace(after)


PushRosNamespace = PushROSNamespace
