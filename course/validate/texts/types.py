"""Whether interface types in `ros2` lines exist, as far as this machine and the course can tell."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from course.content.names import did_you_mean
from course.errors import MissingHere
from course.rosenv import find_ros
from course.rosenv.underlay import source_root
from course.validate.texts.shell_lines import Command

_TYPE = re.compile(r"([a-z][a-z0-9_]*)/(msg|srv|action)/([A-Z]\w*)")


class Types:
    """The interfaces of the course's own solutions, of the underlay, and of the ROS that is here."""

    def __init__(self, course: Path) -> None:
        self._places = tuple(_places(course))

    def complaint(self, command: Command) -> str | None:
        """About a type of a package that is known; one that is in none may be an example's."""
        for package, kind, name in filter(None, map(_parts, command.words)):
            folders = [folder for place in self._places for folder in place.glob(f"{package}/{kind}")]
            known = {file.stem for folder in folders for file in folder.glob(f"*.{kind}")}
            if known and name not in known:
                return f"{package} has no {kind} `{name}`{did_you_mean(name, known)}"
        return None


def _parts(word: str) -> tuple[str, str, str] | None:
    match = _TYPE.fullmatch(word)
    return (match[1], match[2], match[3]) if match else None


def _places(course: Path) -> Iterator[Path]:
    """Folders that hold packages."""
    yield from {file.parents[1] for file in course.glob("solutions/**/package.xml")}
    root = source_root()
    if root is not None:
        yield root / "src"
    try:
        yield find_ros().prefix / "share"
    except MissingHere:
        return
