"""Who handed in what, and what was found in it: data that may travel to another process."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from pathlib import Path

from course.home.opening import Finding


@dataclass(frozen=True)
class Person:
    """id: unique in the class, the same each time, and fit for a folder's name. name: safe to show."""

    id: str
    name: str
    late: bool = False


@dataclass(frozen=True)
class Part:
    """A file or folder that belongs to a submission. `name`: as it was handed in."""

    name: str
    path: Path


@dataclass(frozen=True)
class Source:
    """All that one person handed in. `shown`: where it lies, safe to show; findings: what is wrong so far."""

    person: Person
    shown: str
    parts: tuple[Part, ...]
    findings: tuple[Finding, ...] = ()


@dataclass(frozen=True)
class Sources:
    """The submissions of a class, by the person's name; findings: about what is nobody's."""

    each: tuple[Source, ...]
    findings: tuple[Finding, ...] = ()


class Kind(str, Enum):
    """What a submission is. Its value is how a table shows it."""

    HOME = "course home"
    WORKSPACE = "workspace"
    PACKAGES = "packages"
    FILES = "files"
    NOTHING = "nothing"


@dataclass(frozen=True)
class Place:
    """Where something of the submission belongs in a course home; "" is all of it, and the home itself."""

    source: str
    target: str


@dataclass(frozen=True)
class Found:
    """A submission, as far as it can be told without running any of it.

    source: where it lies, safe to show. parts: where its files are, archives opened. root: the folder in
    it that was recognised ("" for the submission itself), safe to show. packages: the names of its ROS
    packages. exercises: ids of those whose files are there. places: for `lay_out`.
    findings: what was left out, and why, most serious first.
    """

    person: Person
    source: str
    kind: Kind
    root: str
    packages: tuple[str, ...]
    exercises: tuple[str, ...]
    findings: tuple[Finding, ...]
    parts: tuple[Part, ...]
    places: tuple[Place, ...]
