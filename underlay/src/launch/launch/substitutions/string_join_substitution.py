"""Texts, joined with something between them."""

from __future__ import annotations

from collections.abc import Iterable

from launch.action import texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.utilities import perform_substitutions


class StringJoinSubstitution(Substitution):
    def __init__(self, substitutions: Iterable[object], delimiter: object = "") -> None:
        self.__parts = [texts(part) for part in substitutions]
        self.__delimiter = texts(delimiter)

    @property
    def substitutions(self) -> list[list[Substitution]]:
        return self.__parts

    @property
    def delimiter(self) -> list[Substitution]:
        return self.__delimiter

    def describe(self) -> str:
        parts = (" + ".join(sub.describe() for sub in part) for part in self.__parts)
        return "StringJoin({})".format(", ".join(parts))

    def perform(self, context: LaunchContext) -> str:
        between = perform_substitutions(context, self.__delimiter)
        return between.join(perform_substitutions(context, part) for part in self.__parts)
