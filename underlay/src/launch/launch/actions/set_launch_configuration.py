"""Give a launch configuration a value."""

from __future__ import annotations

from typing import Any

from launch.action import Action, texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.utilities import perform_substitutions


class SetLaunchConfiguration(Action):
    def __init__(self, name: object, value: object, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__name = texts(name)
        self.__value = texts(value)

    @property
    def name(self) -> list[Substitution]:
        return self.__name

    @property
    def value(self) -> list[Substitution]:
        return self.__value

    def execute(self, context: LaunchContext) -> None:
        name = perform_substitutions(context, self.__name)
        context.launch_configurations[name] = perform_substitutions(context, self.__value)
