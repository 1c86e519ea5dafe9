"""What was built for a recording, as plain data."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from course.feedback import Feedback, feedback_from_dict


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
    """All packages built for an exercise; `failure` says why the build failed, if it did."""

    built: tuple[BuiltPackage, ...] = ()
    failure: Feedback | None = None

    def get(self, name: str) -> BuiltPackage | None:
        return next((package for package in self.built if package.name == name), None)


def packages_from_dict(data: Mapping[str, Any]) -> BuiltPackages:
    """Built packages out of their JSON form."""
    built = (BuiltPackage(**{**item, "executables": tuple(item["executables"])}) for item in data["built"])
    return BuiltPackages(tuple(built), feedback_from_dict(data["failure"]))
