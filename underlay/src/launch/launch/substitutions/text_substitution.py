"""A plain text."""

from __future__ import annotations

from launch.launch_context import LaunchContext
from launch.substitution import Substitution


class TextSubstitution(Substitution):
    """Stands for itself."""

    def __init__(self, *, text: str) -> None:
        if not isinstance(text, str):
            raise TypeError(
                "TextSubstitution expected Text object got '{}' instead.".format(type(text))  # noqa: UP032
            )
        self.__text = text

    @property
    def text(self) -> str:
        return self.__text

    def describe(self) -> str:
        return f"'{self.__text}'"

    def perform(self, context: LaunchContext) -> str:
        return self.__text
