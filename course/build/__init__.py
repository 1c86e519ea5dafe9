"""Builds learners' packages with colcon, outside their folders, and says why a build failed."""

from course.build.build_outcome import BuildFailure, BuildOutcome, InstalledPackage
from course.build.builder import build
from course.build.runner import Interrupt, Interrupted
from course.build.store import Store
from course.build.workspace import Package, Workspace

__all__ = [
    "BuildFailure",
    "BuildOutcome",
    "InstalledPackage",
    "Interrupt",
    "Interrupted",
    "Package",
    "Store",
    "Workspace",
    "build",
]
