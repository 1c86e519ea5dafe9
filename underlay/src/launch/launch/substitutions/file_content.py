"""What a file contains."""

from __future__ import annotations

from pathlib import Path

from launch.action import texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities import perform_substitutions


class FileContent(Substitution):
    def __init__(self, path: object) -> None:
        self.__path = texts(path)

    def describe(self) -> str:
        return "FileContent({})".format(" + ".join(sub.describe() for sub in self.__path))

    def perform(self, context: LaunchContext) -> str:
        path = perform_substitutions(context, self.__path)
        try:
            return Path(path).read_text(encoding="utf-8")
        except OSError as error:
            raise SubstitutionFailure(f"Failed to open file: {path}: {error.strerror}") from error
