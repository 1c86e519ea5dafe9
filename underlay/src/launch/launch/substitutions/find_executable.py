"""Where a program is on the PATH."""

from __future__ import annotations

import shutil

from launch.action import texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities import perform_substitutions


class FindExecutable(Substitution):
    def __init__(self, *, name: object) -> None:
        self.__name = texts(name)

    @property
    def name(self) -> list[Substitution]:
        return self.__name

    def describe(self) -> str:
        return "FindExec({})".format(" + ".join(sub.describe() for sub in self.__name))

    def perform(self, context: LaunchContext) -> str:
        name = perform_substitutions(context, self.__name)
        found = shutil.which(name, path=context.environment.get("PATH"))
        if found is None:
            raise SubstitutionFailure(f"executable '{name}' not found on the PATH")
        return found
