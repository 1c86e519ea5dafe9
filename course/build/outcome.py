"""What a build ends with: plain data."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from course.feedback import Feedback


@dataclass(frozen=True)
class BuiltPackage:
    """One package that is ready to be used.

    source: its folder, relative to the course home, as the learner knows it.
    prefix: its install prefix, made for this content alone; nobody writes to it again.
    cached: it had been built before; seconds: what this build of it took, 0 when cached.
    """

    name: str
    source: str
    prefix: Path
    cached: bool
    seconds: float


@dataclass(frozen=True)
class BuildFailure:
    """A package that cannot be built as it stands, and why. Always the learner's to repair.

    kind: a short stable word for the cause ("package-missing", "setup-py", "cmake-syntax", ...).
    log: everything the build printed, if it came to run at all.
    """

    package: str
    kind: str
    feedback: Feedback
    log: Path | None = None


@dataclass(frozen=True)
class BuildOutcome:
    """All that was asked for and what it depends on, dependencies first; or as far as it got."""

    packages: tuple[BuiltPackage, ...]
    failure: BuildFailure | None
    seconds: float

    @property
    def prefixes(self) -> tuple[Path, ...]:
        """Install prefixes, dependencies first: the last one goes on top."""
        return tuple(package.prefix for package in self.packages)
