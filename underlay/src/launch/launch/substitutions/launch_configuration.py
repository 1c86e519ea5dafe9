"""The value of a launch configuration, which is what a launch argument sets."""

from __future__ import annotations

from collections.abc import Iterable

from launch.action import texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities import perform_substitutions


class LaunchConfiguration(Substitution):
    """`default` is taken where the configuration is not set."""

    def __init__(self, variable_name: object, *, default: object | None = None) -> None:
        self.__name = texts(variable_name)
        self.__default = None if default is None else texts(_as_text(default))

    @property
    def variable_name(self) -> list[Substitution]:
        return self.__name

    def describe(self) -> str:
        return "LaunchConfig({})".format(" + ".join(sub.describe() for sub in self.__name))

    def perform(self, context: LaunchContext) -> str:
        name = perform_substitutions(context, self.__name)
        if name in context.launch_configurations:
            return str(context.launch_configurations[name])
        if self.__default is None:
            raise SubstitutionFailure(f"launch configuration '{name}' does not exist")
        return perform_substitutions(context, self.__default)


def _as_text(default: object) -> object:
    """Numbers and the like are allowed as defaults."""
    if isinstance(default, str | Substitution):
        return default
    return [_as_text(item) for item in default] if isinstance(default, Iterable) else str(default)
