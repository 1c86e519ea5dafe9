"""Add to a variable that is a list, such as PATH."""

from __future__ import annotations

import os
from typing import Any

from launch.action import texts
from launch.actions.named import NamedValue
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.utilities import perform_substitutions


class AppendEnvironmentVariable(NamedValue):
    """At its end, or with `prepend` before all that is there."""

    def __init__(
        self,
        name: object,
        value: object,
        prepend: object = False,
        separator: object = os.pathsep,
        **kwargs: Any,
    ) -> None:
        super().__init__(name, value, **kwargs)
        self.__prepend = texts(str(prepend) if isinstance(prepend, bool) else prepend)
        self.__separator = texts(separator)

    @property
    def prepend(self) -> list[Substitution]:
        return self.__prepend

    @property
    def separator(self) -> list[Substitution]:
        return self.__separator

    def execute(self, context: LaunchContext) -> None:
        from launch.conditions import evaluate_condition_expression

        name, value = self._performed(context)
        before = [context.environment[name]] if name in context.environment else []
        first = evaluate_condition_expression(context, self.__prepend)
        between = perform_substitutions(context, self.__separator)
        context.environment[name] = between.join([value, *before] if first else [*before, value])
