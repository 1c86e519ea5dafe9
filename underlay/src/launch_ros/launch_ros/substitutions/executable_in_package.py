"""A program of a package."""

from __future__ import annotations

import os
from pathlib import Path

from launch.action import texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities import perform_substitutions

from launch_ros.substitutions.find_package import FindPackagePrefix


class ExecutableInPackage(FindPackagePrefix):
    """Its path, `<prefix>/lib/<package>/<executable>`."""

    def __init__(self, executable: object, package: object) -> None:
        super().__init__(package)
        self.__executable = texts(executable)

    @property
    def executable(self) -> list[Substitution]:
        return self.__executable

    def describe(self) -> str:
        package = " + ".join(sub.describe() for sub in self.package)
        executable = " + ".join(sub.describe() for sub in self.__executable)
        return f"ExecInPkg(pkg={package}, exec={executable})"

    def perform(self, context: LaunchContext) -> str:
        executable = perform_substitutions(context, self.__executable)
        package = perform_substitutions(context, self.package)
        folder = Path(super().perform(context)) / "lib" / package
        if not folder.is_dir():
            raise SubstitutionFailure(
                f"package '{package}' found at '{folder.parent.parent}', but libexec directory '{folder}' "
                "does not exist"
            )
        if not os.access(folder / executable, os.X_OK):
            # The space at the end is the real one's.
            raise SubstitutionFailure(
                f"executable '{executable}' not found on the libexec directory '{folder}' "
            )
        return str(folder / executable)
