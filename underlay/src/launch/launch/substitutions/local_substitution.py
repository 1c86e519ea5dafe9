"""A local value of the launch."""

from __future__ import annotations

from launch.launch_context import LaunchContext
from launch.substitution import Substitution


class LocalSubstitution(Substitution):
    """`expression` goes on where `context.locals.` ends."""

    def __init__(self, expression: str, description: str | None = None) -> None:
        self.__expression = expression
        self.__description = description

    @property
    def expression(self) -> str:
        return self.__expression

    def describe(self) -> str:
        return f"LocalVar('{self.__description or self.__expression}')"

    def perform(self, context: LaunchContext) -> str:
        return str(eval(f"context.locals.{self.__expression}", {}, {"context": context}))
