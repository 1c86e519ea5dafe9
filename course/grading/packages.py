"""From what the build made to what a recording keeps of it."""

from __future__ import annotations

from course.arena.executables import installed_executables
from course.build import BuildOutcome
from course.evidence.packages import BuiltPackage, BuiltPackages


def as_evidence(outcome: BuildOutcome) -> BuiltPackages:
    """The packages with the executables that are really installed, and the failure if any."""
    built = tuple(
        BuiltPackage(
            package.name,
            package.source,
            str(package.prefix),
            installed_executables(package.prefix, package.name),
        )
        for package in outcome.packages
    )
    return BuiltPackages(built, outcome.failure.feedback if outcome.failure else None)
