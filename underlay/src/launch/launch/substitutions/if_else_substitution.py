"""One of two texts."""

from __future__ import annotations

from launch.action import texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.substitutions.boolean_substitution import truth
from launch.utilities import perform_substitutions


class IfElseSubstitution(Substitution):
    def __init__(self, condition: object, if_value: object = "", else_value: object = "") -> None:
        if if_value == "" and else_value == "":
            raise RuntimeError("One of if_value and else_value must be specified")
        self.__condition = texts(condition)
        self.__if_value = texts(if_value)
        self.__else_value = texts(else_value)

    @property
    def condition(self) -> list[Substitution]:
        return self.__condition

    @property
    def if_value(self) -> list[Substitution]:
        return self.__if_value

    @property
    def else_value(self) -> list[Substitution]:
        return self.__else_value

    def describe(self) -> str:
        return "IfElseSubstitution({})".format(" + ".join(sub.describe() for sub in self.__condition))

    def perform(self, context: LaunchContext) -> str:
        chosen = self.__if_value if truth(context, self.__condition) else self.__else_value
        return perform_substitutions(context, chosen)
