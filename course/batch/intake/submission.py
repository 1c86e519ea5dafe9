"""Who handed in what, and what was found in it: data that may travel to another process."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from pathlib import Path

from msgspec import Struct

from course.home.opening import Remark
from course.model.gradebook import Person


@dataclass(frozen=True)
class Part:
    """A file or folder that belongs to a submission. `name`: as it was handed in."""

    name: str
    path: Path


@dataclass(frozen=True)
class Upload:
    """All that one person handed in. `shown`: its path, safe to show; findings: what is wrong so far."""

    person: Person
    shown: str
    parts: tuple[Part, ...]
    findings: tuple[Remark, ...] = ()


@dataclass(frozen=True)
class Uploads:
    """The submissions of a class, by the person's name; findings: about what belongs to nobody."""

    each: tuple[Upload, ...]
    findings: tuple[Remark, ...] = ()


class Claim(Struct, frozen=True):
    """What `pack` saw of one exercise, as the learner's zip says. checks: outcome by id."""

    exercise: str
    verdict: str
    points: float
    max_points: float
    checks: dict[str, str]


class PackManifest(Struct, frozen=True):
    """at: ISO 8601. versions: of ros2course, ROS 2 and Python. files: SHA-256 by path in the course home.

    Learners can write anything they like into it, so nothing counts because of it.
    """

    schema: int
    at: str
    versions: dict[str, str]
    claims: tuple[Claim, ...]
    files: dict[str, str]


class SubmissionKind(str, Enum):
    """What a submission is. The values are texts for tables."""

    HOME = "course home"
    WORKSPACE = "workspace"
    PACKAGES = "packages"
    FILES = "files"
    UNREADABLE = "unreadable"
    NOTHING = "nothing"


@dataclass(frozen=True)
class Placement:
    """Where something in the submission belongs in a course home.

    source: "" for all of it. target: "" for the home itself, None for what is left out.
    """

    source: str
    target: str | None


@dataclass(frozen=True)
class Found:
    """What is known about a submission without running any of it.

    source: its path, safe to show. parts: where its files are, with archives opened. root: the folder in
    it that was recognized ("" for the submission itself), safe to show. packages: the names of its ROS
    packages. exercises: ids of those whose files are there. places: for `lay_out`.
    findings: what was left out, and why, most serious first. packed: what `pack` wrote.
    beneath: folders of the course, and where their files go if nothing was handed in there.
    written: files that replace what was handed in.
    """

    person: Person
    source: str
    kind: SubmissionKind
    root: str
    packages: tuple[str, ...]
    exercises: tuple[str, ...]
    findings: tuple[Remark, ...]
    parts: tuple[Part, ...]
    places: tuple[Placement, ...]
    packed: PackManifest | None = None
    beneath: tuple[tuple[Path, str], ...] = ()
    written: tuple[tuple[str, bytes], ...] = ()
