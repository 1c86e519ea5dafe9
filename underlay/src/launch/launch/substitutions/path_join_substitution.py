"""Parts of a path, joined."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import PurePath

from launch.action import texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.utilities import perform_substitutions


class PathJoinSubstitution(Substitution):
    """Each part is a text, a substitution, or a list of them that make one part."""

    def __init__(self, substitutions: Iterable[object]) -> None:
        self.__parts = [texts(part) for part in substitutions]

    @property
    def substitutions(self) -> list[list[Substitution]]:
        return self.__parts

    def describe(self) -> str:
        parts = (" + ".join(sub.describe() for sub in part) for part in self.__parts)
        return "PathJoin({})".format(", ".join(parts))

    def perform(self, context: LaunchContext) -> str:
        parts = [perform_substitutions(context, part) for part in self.__parts]
        return _joined(parts)

    def __truediv__(self, more: object) -> PathJoinSubstitution:
        return PathJoinSubstitution([*self.__parts, more])


class PathSubstitution(PathJoinSubstitution):
    """A path to which `/` adds parts."""

    def __init__(self, path: object) -> None:
        super().__init__([path])


def _joined(parts: list[str]) -> str:
    """As os.path.join: `..` and a trailing slash stay as they were written."""
    import os.path

    return os.path.join(*parts) if parts else str(PurePath())  # noqa: PTH118  pathlib drops the slash
