"""Add to a variable that is a list, such as PATH."""

from __future__ import annotations

import os
from typing import Any

from launch.action import Action, texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.utilities import perform_substitutions


class AppendEnvironmentVariable(Action):
    """At its end, or with `prepend` before all that is there."""

    def __init__(
        self,
        name: object,
        value: object,
        prepend: object = False,
        separator: object = os.pathsep,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__name = texts(name)
        self.__value = texts(value)
        self.__prepend = texts(str(prepend) if isinstance(prepend, bool) else prepend)
        self.__separator = texts(separator)

    @property
    def name(self) -> list[Substitution]:
        return self.__name

    @property
    def value(self) -> list[Substitution]:
        return self.__value

    @property
    def prepend(self) -> list[Substitution]:
        return self.__prepend

    @property
    def separator(self) -> list[Substitution]:
        return self.__separator

    def execute(self, context: LaunchContext) -> None:
        from launch.conditions import evaluate_condition_expression

        name = perform_substitutions(context, self.__name)
        value = perform_substitutions(context, self.__value)
        before = [context.environment[name]] if name in context.environment else []
        first = evaluate_condition_expression(context, self.__prepend)
        between = perform_substitutions(context, self.__separator)
        context.environment[name] = between.join([value, *before] if first else [*before, value])
