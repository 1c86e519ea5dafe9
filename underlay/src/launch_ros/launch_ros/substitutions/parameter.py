"""The value of a parameter that SetParameter has set."""

from __future__ import annotations

from launch.action import texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities import perform_substitutions


class Parameter(Substitution):
    def __init__(self, name: object, *, default: object | None = None) -> None:
        self.__name = texts(name)
        self.__default = None if default is None else texts(default)

    @property
    def name(self) -> list[Substitution]:
        return self.__name

    def describe(self) -> str:
        return "Parameter({})".format(" + ".join(sub.describe() for sub in self.__name))

    def perform(self, context: LaunchContext) -> str:
        name = perform_substitutions(context, self.__name)
        for entry in reversed(context.launch_configurations.get("global_params", [])):
            if isinstance(entry, tuple) and entry[0] == name:
                return str(entry[1])
        if self.__default is None:
            raise SubstitutionFailure(f"parameter '{name}' not found")
        return perform_substitutions(context, self.__default)
