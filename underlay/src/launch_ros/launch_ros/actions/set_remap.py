"""A remapping for all nodes that follow."""

from __future__ import annotations

from typing import Any

from launch.action import Action, texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.utilities import perform_substitutions


class SetRemap(Action):
    """Ends with its group."""

    def __init__(self, src: object, dst: object, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__src = texts(src)
        self.__dst = texts(dst)

    @property
    def src(self) -> list[Substitution]:
        return self.__src

    @property
    def dst(self) -> list[Substitution]:
        return self.__dst

    def execute(self, context: LaunchContext) -> None:
        rule = (perform_substitutions(context, self.__src), perform_substitutions(context, self.__dst))
        before = context.launch_configurations.get("ros_remaps", [])
        context.launch_configurations["ros_remaps"] = [*before, rule]
