"""Who handed in what, judging by the names that Moodle, Canvas and GitHub Classroom give to files."""

from __future__ import annotations

import hashlib
import os
import re
import unicodedata
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from datetime import datetime
from enum import Enum
from itertools import takewhile

from course.batch.intake.recognize import number_of_try
from course.batch.intake.submission import Part, Upload, Uploads
from course.home.opening import Opened, Remark, archive_stem, is_archive, visible
from course.model import replace
from course.model.gradebook import Person

# Jane Doe_1234567_assignsubmission_file_, with or without a file's name after it
_MOODLE = re.compile(r"(?P<name>.+?)_(?P<id>\d+)_assignsubmission_[a-z]+(?:_(?P<file>.*))?", re.DOTALL)
# doejane_12345_67890_file.zip, doejane_LATE_12345_67890_file-1.zip, doejane_12345_text.html, and
# LATE_anon_k3Xp9_67890_file.zip if grading is anonymous
_CANVAS = re.compile(
    r"(?:(?P<name>[^\W_]+)_)?(?P<late>LATE_)?(?(name)(?P<id>\d+)|anon_(?P<anonymous>[^\W_]{5}))_"
    r"(?:(?P<upload>\d+)_(?P<file>.+)|(?P<text>(?:text|link)\.html))",
    re.DOTALL,
)
_MOODLE_ID = re.compile(r"_(\d+)_assignsubmission_[a-z]+(?:_|$)")
_LINK = "link.html"
_MOODLE_TIMES = ("%A, %d %B %Y, %I:%M %p", "%A, %d %B %Y, %H:%M")
_SUBMISSIONS = "-submissions"
_LONGEST_ID = 64
_NO_ID = re.compile(r"[^\w.@+-]+")


@dataclass(frozen=True)
class Label:
    """What a name says. file: the name under which the file was handed in, "" for a folder.

    upload: a number that is higher for later uploads; 0 if the name does not say.
    """

    person: Person
    file: str
    is_lms: bool
    upload: int = 0


class Lms(str, Enum):
    """The system that an export comes from."""

    MOODLE = "Moodle"
    CANVAS = "Canvas"


def lms_id(source: str, lms: Lms) -> str:
    """The LMS's number for the person who handed this in, from the names in its export; "" if unknown."""
    names = source.split(", ")
    if lms is Lms.MOODLE:
        return next((found[1] for found in map(_MOODLE_ID.search, names) if found), "")
    return next((found["id"] for found in map(_CANVAS.fullmatch, names) if found and found["id"]), "")


def labels(names: Iterable[str]) -> dict[str, Label]:
    """Whose the folders and files in one place are, by their names."""
    every = tuple(names)
    uploads = Counter(match["upload"] for name in every if (match := _CANVAS.fullmatch(name)))
    return {name: _moodle(name) or _canvas(name, uploads) or _plain(name) for name in every}


def person(identity: str, name: str, *, late: bool | None = None) -> Person:
    return Person(safe_id(identity), visible(" ".join(name.split())), late)


def iso_moment(text: str) -> datetime:
    """Like datetime.fromisoformat, which does not accept `Z` before Python 3.11. Raises ValueError."""
    return datetime.fromisoformat(re.sub(r"[zZ]$", "+00:00", text))


def moment(text: str) -> datetime | None:
    """A date and a time as rosters (ISO 8601) and Moodle write them; None for anything else."""
    try:
        return iso_moment(text)
    except ValueError:
        pass
    for form in _MOODLE_TIMES:
        try:
            return datetime.strptime(text, form)
        except ValueError:
            continue
    return None


def safe_id(text: str) -> str:
    """An id for `text`, always the same, made of letters, digits and `_.@+-`. Texts that differ only in other
    characters can get the same id."""
    normal = unicodedata.normalize("NFC", text)
    safe = _NO_ID.sub("_", normal).strip("_.@+-")
    if not safe or len(safe.encode()) > _LONGEST_ID:
        return f"{safe[:16] or 'submission'}-{fingerprint(text)}"
    return safe


def fingerprint(text: str) -> str:
    return hashlib.sha256(os.fsencode(text)).hexdigest()[:8]


def assignment(clones: Iterable[str], folder: str) -> str:
    """What the names of GitHub Classroom's clones have in common (`lab1-` of `lab1-jane`), or "".

    `gh classroom clone` calls the folder that contains them `lab1-submissions`. Without such a folder, it
    takes two or more names to find out.
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
    # Each upload has its own number. If several names share one, they are not from Canvas.
    if match is None or (match["upload"] and uploads[match["upload"]] > 1):
        return None
    identity = match["id"] or match["anonymous"]
    who = person(identity, match["name"] or identity, late=match["late"] is not None)
    return Label(who, match["file"] or match["text"], True, int(match["upload"] or 0))


def _plain(name: str) -> Label:
    stem = archive_stem(name) if is_archive(name) else name
    return Label(person(stem, stem), "", False)


PASSED_OVER = "Files that are not a submission were ignored."
LINKED = Remark(
    "A link was handed in instead of files. Links are not followed.",
    "Ask for an archive, or clone what the link leads to.",
)


def grouped(items: Sequence[Opened], folder: str) -> Uploads:
    """Uploads from the folders and files in one place, called `folder`. The order does not matter."""
    items = sorted(items, key=lambda item: item.name)
    clones = [item.name for item in items if item.path and (item.path / ".git").exists()]
    told = _clones(labels(item.name for item in items), clones, assignment(clones, folder))
    passed_over: list[str] = []
    people: dict[tuple[str, ...], list[Opened]] = {}
    for item in items:
        label = told[item.name]
        if label.is_lms:
            people.setdefault((label.person.id, label.person.name), []).append(item)
        elif item.path is None or item.path.is_dir() or is_archive(item.name):
            people[(item.name,)] = [item]
        else:
            passed_over.append(visible(item.name))
    sources = unique([_source(own, told) for own in people.values()])
    return Uploads(sources, (Remark(PASSED_OVER, where=", ".join(passed_over)),) if passed_over else ())


def _clones(told: dict[str, Label], clones: Iterable[str], slug: str) -> dict[str, Label]:
    own = {name: name.removeprefix(slug) for name in clones if slug and not told[name].is_lms}
    return {**told, **{name: Label(person(user, user), "", False) for name, user in own.items() if user}}


def _source(items: Sequence[Opened], told: dict[str, Label]) -> Upload:
    """The newest part first, judging by the names."""
    items = sorted(items, key=lambda item: _age(told[item.name]), reverse=True)
    first = told[items[0].name].person
    known = [late for item in items if (late := told[item.name].person.late) is not None]
    late = any(known) if known else None
    parts = tuple(Part(told[item.name].file or item.name, item.path) for item in items if item.path)
    findings = tuple(finding for item in items for finding in item.findings)
    if any(told[item.name].file == _LINK for item in items):
        findings += (LINKED,)
    shown = ", ".join(visible(item.name) for item in items)
    return Upload(Person(first.id, first.name, late), shown, parts, findings)


def _age(label: Label) -> tuple[int, int]:
    return label.upload, number_of_try(label.file)


def unique(sources: Iterable[Upload]) -> tuple[Upload, ...]:
    """If an id occurs twice, all but the first get one made from their own names, and all are told."""
    every = tuple(sources)
    count = Counter(source.person.id for source in every)
    seen: set[str] = set()
    return tuple(_told_apart(source, seen) if count[source.person.id] > 1 else source for source in every)


def _told_apart(source: Upload, seen: set[str]) -> Upload:
    who = source.person
    what = f"More than one submission has the id {who.id}."
    finding = Remark(what, "They are graded separately; remove those that do not count.", source.shown)
    if who.id in seen:
        who = replace(who, id=f"{who.id}-{fingerprint(source.shown)}")
    seen.add(source.person.id)
    return replace(source, person=who, findings=(*source.findings, finding))
