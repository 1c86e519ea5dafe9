"""The names that follow from what an author calls a chapter or an exercise."""

from __future__ import annotations

import re
from dataclasses import dataclass

from course.errors import UsageError

_SLUG = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*")
_LONGEST = 40


@dataclass(frozen=True)
class ChapterName:
    """`30-power-supply`: its folder, number and title."""

    number: int
    slug: str

    @property
    def folder(self) -> str:
        return f"{self.number:02d}-{self.slug}"

    @property
    def title(self) -> str:
        return titled(self.slug)


@dataclass(frozen=True)
class ExerciseName:
    """`30-battery-level`: its id, and what its package, node, topic and Python names are made of."""

    number: int
    slug: str

    @property
    def id(self) -> str:
        return f"{self.number:02d}-{self.slug}"

    @property
    def title(self) -> str:
        return titled(self.slug)

    @property
    def snake(self) -> str:
        return self.slug.replace("-", "_")

    @property
    def package(self) -> str:
        return f"{self.snake}_package"

    @property
    def node(self) -> str:
        return f"{self.snake}_node"

    @property
    def node_class(self) -> str:
        return "".join(part.capitalize() for part in self.slug.split("-")) + "Node"


def titled(slug: str) -> str:
    """`battery-level` as a heading: `Battery level`."""
    return slug.replace("-", " ").capitalize()


def number_and_slug(name: str, number: int | None = None) -> tuple[int | None, str]:
    """`30-battery` in its two parts; `number` where none is written. Raises UsageError for no such name."""
    match = re.fullmatch(r"(?:(\d\d)-)?(.*)", name, re.DOTALL)
    written, slug = (match[1], match[2]) if match else (None, name)
    if not _SLUG.fullmatch(slug):
        raise UsageError(
            f"`{name}` is not a name for a chapter or an exercise",
            "allowed: small letters and digits joined by dashes, a letter first, and two digits and a dash "
            "before them: `30-battery`",
        )
    if len(slug) > _LONGEST:
        raise UsageError(f"`{slug}` is too long for a name", f"use at most {_LONGEST} letters")
    return (int(written) if written else number), slug
