"""Several actions as one, with values of their own."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from launch.action import Action
from launch.actions.pop_environment import PopEnvironment
from launch.actions.pop_launch_configurations import PopLaunchConfigurations
from launch.actions.push_environment import PushEnvironment
from launch.actions.push_launch_configurations import PushLaunchConfigurations
from launch.actions.reset_environment import ResetEnvironment
from launch.actions.reset_launch_configurations import ResetLaunchConfigurations
from launch.actions.set_launch_configuration import SetLaunchConfiguration
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity


class GroupAction(Action):
    """`scoped`: what the actions set ends with the group. `forwarding`: they see what was set before it."""

    def __init__(
        self,
        actions: Iterable[LaunchDescriptionEntity],
        *,
        scoped: bool = True,
        forwarding: bool = True,
        launch_configurations: Mapping[Any, Any] | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__actions = list(actions)
        self.__scoped = scoped
        self.__forwarding = forwarding
        self.__configurations = dict(launch_configurations or {})

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        setting = [SetLaunchConfiguration(name, value) for name, value in self.__configurations.items()]
        if not self.__scoped:
            return [*setting, *self.__actions]
        begin = [PushLaunchConfigurations(), PushEnvironment()]
        # What is given is found out before all else is forgotten.
        fresh = [ResetEnvironment(), ResetLaunchConfigurations(self.__configurations)]
        own = setting if self.__forwarding else fresh
        return [*begin, *own, *self.__actions, PopEnvironment(), PopLaunchConfigurations()]

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        return [] if self.condition is not None else self.__actions

    def describe_conditional_sub_entities(self) -> list[tuple[str, list[LaunchDescriptionEntity]]]:
        return [] if self.condition is None else [("if the condition holds", self.__actions)]

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        return self.get_sub_entities()
