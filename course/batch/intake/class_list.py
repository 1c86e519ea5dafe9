"""Who is in the class: a list that an LMS exports, or a roster, merged with what was handed in."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from course.batch.intake.people import moment, person, safe_id
from course.batch.intake.submission import Upload, Uploads
from course.batch.intake.uploads import read_table
from course.errors import UsageError
from course.home.opening import Remark, visible
from course.model import replace
from course.model.gradebook import Person

# Names of columns in Canvas, Moodle, Blackboard, Classroom 50 and our own rosters, reduced to their letters.
_ID = ("canvasuserid", "identifier", "id", "idnumber", "username", "emailaddress", "email")
_OTHER_IDS = ("sisuserid", "sisloginid", "userid", "loginid", "studentid", *_ID)
_NAME = ("student", "fullname", "name")
_FIRST, _LAST = ("firstname",), ("lastname", "surname")
_GROUP = ("group", "groups", "groupname")
_TIME = ("submitted", "lastmodified(submission)")
_PARTICIPANT = re.compile(r"Participant (\d+)")
_FORM = "Export Canvas's gradebook, Moodle's worksheet or participants list, or write id,name,group."
# Names that are not people's: Canvas' second row, and its test student.
_NOBODY = ("Points Possible", "Student, Test")
NOTHING_HANDED_IN = "Nothing was handed in."
NOT_LISTED = "This person is not on the class list."


@dataclass(frozen=True)
class Listed:
    """One line of the list. keys: all ids of the person in it."""

    person: Person
    keys: frozenset[str]


def read_class_list(file: Path) -> tuple[Listed, ...]:
    """Everybody once, in the list's order. Raises UsageError for a file that lists nobody."""
    table = read_table(file, "a class list", _FORM)
    rows = [{_letters(head): cell for head, cell in row.items()} for row in table]
    found = {one.person.id: one for row in rows if (one := _listed(row))}
    if not found:
        raise UsageError(f"{visible(file.name)} lists nobody: it has no column of ids or names.", _FORM)
    return tuple(found.values())


def merged(uploads: Uploads, listed: Sequence[Listed]) -> Uploads:
    """The class: everybody on the list, with what they handed in, and anyone else who handed in something."""
    own = _own(uploads.each, listed)
    taken = {upload.person.id for upload in own.values()}
    everybody = [_together(one, own.get(one.person.id)) for one in listed]
    others = [_with(upload, NOT_LISTED) for upload in uploads.each if upload.person.id not in taken]
    return replace(uploads, each=(*everybody, *others))


def in_groups(uploads: Uploads) -> Uploads:
    """Let one submission of each group count for all of its members: the last one that was handed in.

    If the times are not known, it is the first one in the order of the class. All members are told.
    """
    groups: dict[str, list[Upload]] = {}
    for upload in uploads.each:
        if upload.person.group:
            groups.setdefault(upload.person.group, []).append(upload)
    counting = {name: _counting(members) for name, members in groups.items()}
    return replace(
        uploads, each=tuple(_as_member(one, counting.get(one.person.group)) for one in uploads.each)
    )


def id_of(cell: str) -> str:
    """The id of the person in a cell: 123 for Moodle's `Participant 123`; empty for an empty cell."""
    text = cell.strip()
    number = _PARTICIPANT.fullmatch(text)
    return safe_id(number[1] if number else text) if text else ""


def _letters(head: str) -> str:
    return re.sub(r"[\s_-]+", "", head.strip().lower())


def _first(row: Mapping[str, str], columns: Iterable[str]) -> str:
    return next((row[column] for column in columns if row.get(column)), "")


def _listed(row: Mapping[str, str]) -> Listed | None:
    name = _first(row, _NAME) or f"{_first(row, _FIRST)} {_first(row, _LAST)}".strip()
    identity = _first(row, _ID)
    if not identity or name in _NOBODY:
        return None
    who = person(id_of(identity), name or identity)
    keys = {safe_id(row[column]) for column in _OTHER_IDS if row.get(column)}
    told = replace(who, group=_first(row, _GROUP), handed_in=moment(_first(row, _TIME)))
    return Listed(told, frozenset({who.id, *keys}))


def _own(uploads: Iterable[Upload], listed: Sequence[Listed]) -> dict[str, Upload]:
    """Uploads by the id on the list, found by any id, or by a name that only one listed person has."""
    keys = {key: one.person.id for one in listed for key in one.keys}
    count = Counter(_plain(one.person.name) for one in listed)
    names = {_plain(one.person.name): one.person.id for one in listed}
    found: dict[str, Upload] = {}
    later = []
    for upload in uploads:
        key = keys.get(upload.person.id)
        if key is not None:
            found.setdefault(key, upload)
        else:
            later.append(upload)
    for upload in later:
        name = _plain(upload.person.name)
        if count[name] == 1:
            found.setdefault(names[name], upload)
    return found


def _plain(name: str) -> str:
    return " ".join(name.casefold().split())


def _together(one: Listed, upload: Upload | None) -> Upload:
    """Keep the id on the list, so that the LMS's own sheet can be filled in."""
    if upload is None:
        return Upload(replace(one.person, handed_in=None), "", (), (Remark(NOTHING_HANDED_IN),))
    at = one.person.handed_in or upload.person.handed_in
    return replace(upload, person=replace(one.person, late=upload.person.late, handed_in=at))


def _with(upload: Upload, what: str) -> Upload:
    return replace(upload, findings=(*upload.findings, Remark(what)))


def _counting(members: Sequence[Upload]) -> Upload | None:
    """The member of a group whose submission counts."""
    handed_in = [one for one in members if one.parts]
    times = [one.person.handed_in for one in handed_in]
    if not handed_in or not all(times):
        return handed_in[0] if handed_in else None
    return max(handed_in, key=lambda one: _comparable(one.person.handed_in))


def _comparable(at: datetime | None) -> float:
    return at.timestamp() if at else 0.0


def _as_member(upload: Upload, counting: Upload | None) -> Upload:
    if counting is None or upload.person.id == counting.person.id:
        return upload
    holder = counting.person
    what = f"The submission of {holder.name} counts for the group {visible(holder.group)}."
    who = replace(upload.person, graded_as=holder.id, late=holder.late, handed_in=holder.handed_in)
    return Upload(who, counting.shown, (), (Remark(what),))
