"""What actions about a name have in common: an environment variable, or a launch configuration."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from launch.action import Action, texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.utilities import perform_substitutions


class Named(Action):
    """Has a name."""

    def __init__(self, name: object, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__name = texts(name)

    @property
    def name(self) -> list[Substitution]:
        return self.__name

    def _performed_name(self, context: LaunchContext) -> str:
        return perform_substitutions(context, self.__name)


class NamedValue(Named):
    """Has a name, and a value for it."""

    def __init__(self, name: object, value: object, **kwargs: Any) -> None:
        super().__init__(name, **kwargs)
        self.__value = texts(value)

    @property
    def value(self) -> list[Substitution]:
        return self.__value

    def _performed(self, context: LaunchContext) -> tuple[str, str]:
        return self._performed_name(context), perform_substitutions(context, self.__value)


class Replacing(Action):
    """Has all names that there are to be, with their values; None is none."""

    def __init__(self, values: Mapping[Any, Any] | None = None, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__values = [(texts(name), texts(value)) for name, value in (values or {}).items()]

    def _performed(self, context: LaunchContext) -> dict[str, str]:
        return {
            perform_substitutions(context, name): perform_substitutions(context, value)
            for name, value in self.__values
        }


class Step(Action):
    """Does one thing with the context, and has nothing to say about it."""

    _step: Callable[[LaunchContext], None]

    def execute(self, context: LaunchContext) -> None:
        type(self)._step(context)
