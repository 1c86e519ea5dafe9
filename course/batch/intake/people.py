"""Who handed something in, told by the names that Moodle, Canvas and GitHub Classroom give."""

from __future__ import annotations

import hashlib
import os
import re
import unicodedata
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import takewhile

from course.batch.intake.model import Person
from course.home.opening import archive_stem, is_archive, visible

# Jane Doe_1234567_assignsubmission_file_, with or without a file's name behind it
_MOODLE = re.compile(r"(?P<name>.+?)_(?P<id>\d+)_assignsubmission_[a-z]+(?:_(?P<file>.*))?", re.DOTALL)
# doejane_12345_67890_file.zip, doejane_LATE_12345_67890_file-1.zip, doejane_12345_text.html
_CANVAS = re.compile(
    r"(?P<name>[^\W_]+)(?P<late>_LATE)?_(?P<id>\d+)_(?:(?P<upload>\d+)_(?P<file>.+)|(?P<text>text\.html))",
    re.DOTALL,
)
_SUBMISSIONS = "-submissions"
_LONGEST_ID = 64
_NO_ID = re.compile(r"[^\w.@+-]+")


@dataclass(frozen=True)
class Label:
    """What a name tells. file: the name under which the file was handed in, "" for a folder."""

    person: Person
    file: str
    is_lms: bool


def labels(names: Iterable[str]) -> dict[str, Label]:
    """For each name of a folder or file in one place, whose it is."""
    every = tuple(names)
    uploads = Counter(match["upload"] for name in every if (match := _CANVAS.fullmatch(name)))
    return {name: _moodle(name) or _canvas(name, uploads) or _plain(name) for name in every}


def person(identity: str, name: str, *, late: bool = False) -> Person:
    return Person(safe_id(identity), visible(" ".join(name.split())), late)


def safe_id(text: str) -> str:
    """`text` with nothing but letters, digits and `_.@+-`, the same each time, different for different texts
    as far as they differ in these."""
    normal = unicodedata.normalize("NFC", text)
    safe = _NO_ID.sub("_", normal).strip("_.@+-")
    if not safe or len(safe.encode()) > _LONGEST_ID:
        return f"{safe[:16] or 'submission'}-{fingerprint(text)}"
    return safe


def fingerprint(text: str) -> str:
    return hashlib.sha256(os.fsencode(text)).hexdigest()[:8]


def assignment(clones: Iterable[str], folder: str) -> str:
    """What the names of GitHub Classroom's clones have in common (`lab1-` of `lab1-jane`), or "".

    `gh classroom clone` names the folder that they lie in `lab1-submissions`; otherwise it is told by
    the names, if there are two or more.
    """
    every = tuple(clones)
    named = f"{folder.removesuffix(_SUBMISSIONS)}-"
    if folder.endswith(_SUBMISSIONS) and all(name.startswith(named) for name in every):
        return named
    if len(every) < 2:
        return ""
    words = zip(*(name.split("-") for name in every), strict=False)
    return "".join(f"{same[0]}-" for same in takewhile(lambda each: len(set(each)) == 1, words))


def _moodle(name: str) -> Label | None:
    match = _MOODLE.fullmatch(name)
    return match and Label(person(match["id"], match["name"]), match["file"] or "", True)


def _canvas(name: str, uploads: Counter[str]) -> Label | None:
    match = _CANVAS.fullmatch(name)
    # Each upload has a number of its own; where one stands in several names, they are no names of Canvas.
    if match is None or (match["upload"] and uploads[match["upload"]] > 1):
        return None
    who = person(match["id"], match["name"], late=match["late"] is not None)
    return Label(who, match["file"] or match["text"], True)


def _plain(name: str) -> Label:
    stem = archive_stem(name) if is_archive(name) else name
    return Label(person(stem, stem), "", False)
