"""The same for several values."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable
from typing import Any

import yaml

from launch.action import Action, entities_of, texts
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.substitution import Substitution
from launch.utilities import perform_substitutions


class ForEach(Action):
    """`function` is called with the values of each group: `{a: 1, b: x};{a: 2, b: y}`."""

    def __init__(self, input_values: object, *, function: Callable[..., Any], **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__input_values = texts(input_values)
        self.__function = function

    @property
    def input_values(self) -> list[Substitution]:
        return self.__input_values

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        text = perform_substitutions(context, self.__input_values)
        groups = [yaml.safe_load(group) for group in text.split(";") if group.strip()]
        return [entity for group in groups for entity in entities_of(self._call(group))]

    def _call(self, values: dict[str, Any]) -> Any:
        known = inspect.signature(self.__function).parameters.values()
        if any(each.kind is each.VAR_KEYWORD for each in known):
            return self.__function(**values)
        wanted = {each.name for each in known}
        return self.__function(**{name: value for name, value in values.items() if name in wanted})


class ForLoop(Action):
    """`function` is called with 0, 1, ... and returns entities; `length` says how often."""

    def __init__(
        self,
        length: object,
        *,
        function: Callable[[int], Iterable[LaunchDescriptionEntity] | None],
        name: str | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__length = texts(str(length) if isinstance(length, int) else length)
        self.__function = function

    @property
    def length(self) -> list[Substitution]:
        return self.__length

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        length = int(perform_substitutions(context, self.__length))
        return [entity for index in range(length) for entity in entities_of(self.__function(index))]
