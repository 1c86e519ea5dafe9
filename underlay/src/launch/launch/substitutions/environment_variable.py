"""The value of an environment variable."""

from __future__ import annotations

from launch.action import texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities import perform_substitutions


class EnvironmentVariable(Substitution):
    """`default_value` is taken where the variable is not set."""

    def __init__(self, name: object, *, default_value: object | None = None) -> None:
        self.__name = texts(name)
        self.__default_value = None if default_value is None else texts(default_value)

    @property
    def name(self) -> list[Substitution]:
        return self.__name

    @property
    def default_value(self) -> list[Substitution] | None:
        return self.__default_value

    def describe(self) -> str:
        return "EnvVar({})".format(" + ".join(sub.describe() for sub in self.__name))

    def perform(self, context: LaunchContext) -> str:
        name = perform_substitutions(context, self.__name)
        if name in context.environment:
            return context.environment[name]
        if self.__default_value is None:
            raise SubstitutionFailure(f"environment variable '{name}' does not exist")
        return perform_substitutions(context, self.__default_value)
