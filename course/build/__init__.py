"""Building learners' packages with colcon, away from their folders, and saying why a build failed."""

from course.build.builder import build
from course.build.interrupt import Interrupt, Interrupted
from course.build.outcome import BuildFailure, BuildOutcome, BuiltPackage
from course.build.store import Store
from course.build.workspace import Package, Workspace

__all__ = [
    "BuildFailure",
    "BuildOutcome",
    "BuiltPackage",
    "Interrupt",
    "Interrupted",
    "Package",
    "Store",
    "Workspace",
    "build",
]
