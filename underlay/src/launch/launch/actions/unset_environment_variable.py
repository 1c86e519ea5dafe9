"""Take a variable away from what is started from now on."""

from __future__ import annotations

from typing import Any

from launch.action import Action, texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.utilities import perform_substitutions


class UnsetEnvironmentVariable(Action):
    def __init__(self, name: object, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__name = texts(name)

    @property
    def name(self) -> list[Substitution]:
        return self.__name

    def execute(self, context: LaunchContext) -> None:
        context.environment.pop(perform_substitutions(context, self.__name), None)
