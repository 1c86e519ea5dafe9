"""Digests of all that a submission must not read: what programs/walks.py looks for."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Iterator
from pathlib import Path

from course.content import open_course
from tests.hostile.world import PROGRAMS

REPO = Path(__file__).parents[2]
# Shorter files and lines, and fewer lines, are found in what has nothing to do with the course.
_SHORTEST_FILE = 60
_SHORTEST_LINE = 40
_LINES = 3
_LINES_OF_A_FILE = 6
_IMPORTS = (b"from ", b"import ", b"#include ")
# Programs of ours that run among the learner's, and what their middleware is told.
_SHOWN = ("probe_program.py", "ch17_types.py", "fastdds_profile.xml")
_PARTS = ("chapters", "graders", "solutions")
# What `world.walking` makes a submission of: the files of these solutions are its own.
_WALKING = ("17-interfaces", "18-publisher")


def secrets(*courses: Path, more: Iterable[Path] = ()) -> dict[str, object]:
    """Constants for programs/walks.py: of these courses and our own, of the engine, and of its tests.

    more: further files.
    """
    course = open_course()
    own = [course.exercise(name).solution for name in _WALKING]
    of_courses = [
        file
        for root in (course.root, *courses)
        for part in _PARTS
        for file in _files(root / part)
        if file.name not in _SHOWN
    ]
    ours = [file for top in (REPO / "course", REPO / "tests") for file in _files(top)]
    texts = _texts([*more, *of_courses, *(file for file in ours if file.name not in _SHOWN)])
    open_texts = _texts(file for top in (*own, PROGRAMS, REPO / "underlay/src") for file in _files(top))
    known = {digest for text in open_texts for digest in (_digest(text), *_lines(text))}
    lines = {line for text in _texts(of_courses) for line in list(_lines(text))[:_LINES_OF_A_FILE]}
    return {
        "KNOWN": " ".join(sorted({*map(_digest, texts), *lines} - known)),
        "LENGTHS": {len(text) for text in texts},
        "SHORTEST": _SHORTEST_LINE,
        "LINES": _LINES,
        "FROM": ("qos_overriding_options.py", "librcl.so"),
    }


def _texts(files: Iterable[Path]) -> list[bytes]:
    return [text for text in (file.read_bytes() for file in files) if len(text) >= _SHORTEST_FILE]


def _files(top: Path) -> Iterator[Path]:
    return (file for file in sorted(top.rglob("*")) if file.is_file() and file.name != "LICENSE")


def _lines(text: bytes) -> Iterator[str]:
    """Digests of lines that say something of their own: two programs may well import the same."""
    lines = (line.strip() for line in text.splitlines())
    return (_digest(line) for line in lines if len(line) >= _SHORTEST_LINE and not line.startswith(_IMPORTS))


def _digest(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()[:10]
