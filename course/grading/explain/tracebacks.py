"""A Python traceback, reduced to what the learner needs: the last line, and their own line."""

from __future__ import annotations

import posixpath
import re
from dataclasses import dataclass
from pathlib import PurePosixPath

from course.evidence.packages import BuiltPackages
from course.evidence.sources import Sources
from course.feedback import Location

_ERROR_LINES = 2
_PYTHON_PACKAGES = ("site-packages", "dist-packages")
_FRAME = re.compile(r'^\s*File "(?P<file>[^"]+)", line (?P<line>\d+)')


@dataclass(frozen=True)
class Crash:
    """error: the exception's own line. where: the deepest line of the learner's. shown: telling lines."""

    error: str
    where: Location | None
    shown: tuple[str, ...]


def crash(traceback: tuple[str, ...], packages: BuiltPackages, sources: Sources) -> Crash | None:
    """What this traceback says; None when it is empty."""
    if not traceback:
        return None
    places = [place for place in (_place(line, packages, sources) for line in traceback) if place]
    where = places[-1] if places else None
    start = _error_start(traceback)
    error = " ".join(line.strip() for line in traceback[start : start + _ERROR_LINES] if line.strip(" ^"))
    place = f"{where.file}, line {where.line}:" if where else None
    shown = tuple(line for line in (place, _code_line(where, sources), *traceback[start:]) if line)
    return Crash(error, where, shown)


def _error_start(traceback: tuple[str, ...]) -> int:
    """Index of the exception's own line: the last that is not indented."""
    flush = [index for index, line in enumerate(traceback) if line and not line.startswith((" ", "\t"))]
    words = [index for index, line in enumerate(traceback) if any(map(str.isalpha, line))]
    return (flush or words or [0])[-1]  # of a group of exceptions, all lines are indented


def _place(line: str, packages: BuiltPackages, sources: Sources) -> Location | None:
    frame = _FRAME.match(line)
    if not frame:
        return None
    file = learners_file(frame["file"], packages, sources)
    return Location(file, int(frame["line"])) if file else None


def learners_file(path: str, packages: BuiltPackages, sources: Sources) -> str | None:
    """The source file behind an installed one, relative to the course home."""
    for package in packages.built:
        prefix = package.prefix.rstrip("/") + "/"
        if path.startswith(prefix):
            return _source_of(PurePosixPath(path[len(prefix) :]).parts, package.source, sources)
    return _in_home(path, sources)


def _in_home(path: str, sources: Sources) -> str | None:
    """A script runs in a copy of the home, so its path ends just as it does there."""
    whole = posixpath.normpath(path)
    found = [name for name in sources.files if whole.endswith(f"/{name}")]
    return max(found, key=len) if found else None


def _source_of(installed: tuple[str, ...], folder: str, sources: Sources) -> str | None:
    """What was installed as lib/python3.12/site-packages/talk/talker.py, or as lib/talk/talker.

    A package may keep its modules in a folder of its own, such as `src`, so the way to the file
    may be longer than where it is installed.
    """
    packages = [index for index, part in enumerate(installed) if part in _PYTHON_PACKAGES]
    tail = "/".join(installed[packages[0] + 1 :] if packages else installed[-1:])
    if f"{folder}/{tail}" in sources.files:
        return f"{folder}/{tail}"
    found = [name for name in sources.below(folder).files if name.endswith(f"/{tail}")]
    return found[0] if len(found) == 1 else None


def _code_line(where: Location | None, sources: Sources) -> str | None:
    if where is None or where.line is None:
        return None
    lines = sources.files[where.file].splitlines()
    return "    " + lines[where.line - 1].strip() if where.line <= len(lines) else None
