"""What was built for a recording, as plain data."""

from __future__ import annotations

from dataclasses import dataclass

from course.model.feedback import Feedback


@dataclass(frozen=True)
class BuiltPackage:
    """A package that was built.

    source: its folder, relative to the course home. prefix: where it is installed.
    executables: names that `ros2 run` finds in it.
    """

    name: str
    source: str
    prefix: str
    executables: tuple[str, ...] = ()


@dataclass(frozen=True)
class BuiltPackages:
    """All packages built for an exercise. failure: why the build failed, if it did."""

    built: tuple[BuiltPackage, ...] = ()
    failure: Feedback | None = None

    def get(self, name: str) -> BuiltPackage | None:
        """Return the package of that name; None if it does not exist or could not be built."""
        return next((package for package in self.built if package.name == name), None)
