"""Where a package lies."""

from __future__ import annotations

from launch.action import texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.utilities import perform_substitutions


class FindPackage(Substitution):
    """Base of the two below."""

    def __init__(self, package: object) -> None:
        self.__package = texts(package)

    @property
    def package(self) -> list[Substitution]:
        return self.__package

    def describe(self) -> str:
        package = " + ".join(sub.describe() for sub in self.__package)
        return f"{type(self).__name__}(pkg={package})"

    def find(self, package_name: str) -> str:
        raise NotImplementedError(f"{type(self).__name__} finds nothing: use FindPackageShare")

    def perform(self, context: LaunchContext) -> str:
        return self.find(perform_substitutions(context, self.__package))


class FindPackagePrefix(FindPackage):
    def find(self, package_name: str) -> str:
        from ament_index_python.packages import get_package_prefix

        return str(get_package_prefix(package_name))


class FindPackageShare(FindPackage):
    def find(self, package_name: str) -> str:
        from ament_index_python.packages import get_package_share_directory

        return str(get_package_share_directory(package_name))
