"""The results of a batch: one SQLite file, written as they come, one row per check.

Each grading is one transaction: it is there as a whole or not at all, whatever kills us. The file is in
WAL mode, so that others can read it meanwhile.
"""

from __future__ import annotations

import contextlib
import json
import sqlite3
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from msgspec import Struct

from course.batch.gradings import Graded, Unit
from course.batch.intake.submission import PackManifest
from course.batch.intake.tree import RESULTS
from course.database import BUSY_SECONDS, Database, begin, now, pragma
from course.errors import DamagedData, StorageError, UsageError
from course.model import codec, replace
from course.model.feedback import Feedback
from course.model.gradebook import Person
from course.model.result import Result, Verdict, from_json, to_json

SCHEMA_VERSION = 1
FILE = RESULTS
APPLICATION = 0x726F7334
_ELSEWHERE = "Name another folder with --out."
# Read from an index alone, so a grading that cannot be read still has its keys.
_KEYS = "SELECT rowid, person, exercise FROM gradings"
SCHEMA = f"""
BEGIN IMMEDIATE;
CREATE TABLE batch (key TEXT PRIMARY KEY, value TEXT NOT NULL);
CREATE TABLE submissions (
    person TEXT PRIMARY KEY,
    name TEXT NOT NULL,
    place INTEGER NOT NULL,       -- in the order of the class
    source TEXT NOT NULL,         -- as it was handed in
    digest TEXT NOT NULL,         -- of what was found in it: another digest is graded again
    remarks TEXT NOT NULL         -- JSON, a list of sentences
);
CREATE TABLE gradings (
    person TEXT NOT NULL REFERENCES submissions ON DELETE CASCADE,
    exercise TEXT NOT NULL,
    at TEXT NOT NULL,             -- UTC, ISO 8601
    attempt INTEGER NOT NULL,
    verdict TEXT NOT NULL,
    points REAL NOT NULL,
    max_points REAL NOT NULL,
    containment TEXT NOT NULL,
    seconds REAL NOT NULL,
    lag REAL NOT NULL,
    version TEXT NOT NULL,        -- of the course that graded it
    evidence TEXT,                -- the recording, relative to this file's folder
    result TEXT NOT NULL,         -- JSON, as course.model.result writes it
    PRIMARY KEY (person, exercise)
);
CREATE TABLE checks (
    person TEXT NOT NULL,
    exercise TEXT NOT NULL,
    place INTEGER NOT NULL,
    check_id TEXT NOT NULL,
    title TEXT NOT NULL,
    outcome TEXT NOT NULL,
    earned REAL NOT NULL,
    points REAL NOT NULL,
    bonus INTEGER NOT NULL,
    summary TEXT,
    PRIMARY KEY (person, exercise, check_id),
    FOREIGN KEY (person, exercise) REFERENCES gradings ON DELETE CASCADE
);
PRAGMA application_id = {APPLICATION};
PRAGMA user_version = {SCHEMA_VERSION};
COMMIT;
"""


@dataclass(frozen=True)
class Submission:
    """A submission as it is stored. remarks: sentences about it as a whole."""

    person: str
    name: str
    source: str
    digest: str
    remarks: tuple[str, ...] = ()


@dataclass(frozen=True)
class StoredGrading:
    """A grading as it is stored. evidence: relative to the results' folder, None if there is none.

    damaged: it can no longer be read; its result is then an error of ours, which says so.
    """

    unit: Unit
    result: Result
    evidence: str | None
    seconds: float = 0.0
    damaged: bool = False


class Results(Database):
    """The file in one results folder. A context manager."""

    @classmethod
    def open(cls, folder: Path, *, create: bool = True) -> Results:
        """Raises StorageError for the disk, UsageError for a folder that is not a results' folder."""
        file = folder / FILE
        if not create and not file.is_file():
            raise UsageError(f"{folder} has no results of `grade`.", "Name the folder given to --out.")
        with storage(file):
            folder.mkdir(parents=True, exist_ok=True)
            database = sqlite3.connect(file, timeout=BUSY_SECONDS, isolation_level=None)
            database.text_factory = text_of
            try:
                _make_ready(database, file)
            except BaseException:
                database.close()
                raise
        return cls(database)

    @classmethod
    def look(cls, folder: Path) -> Results:
        """Open for reading only, even while somebody grades into it. Raises what `open` raises."""
        results = cls.open(folder, create=False)
        results._run("PRAGMA query_only = ON")
        return results

    def note(self, key: str, value: str) -> None:
        """Keep something about the batch as a whole."""
        with self.writing():
            self._run("INSERT OR REPLACE INTO batch VALUES (?, ?)", key, value)

    def noted(self, key: str) -> str | None:
        """What `note` kept; the text may be damaged."""
        rows = self._run("SELECT value FROM batch WHERE key = ?", key)
        return str(rows[0][0]) if rows else None

    def enter(self, submissions: Sequence[Submission], held: Iterable[str] = ()) -> None:
        """Make these the submissions. The gradings of one that has changed or is gone are dropped.

        held: people whose submission is not to be read yet; what is known about them stays.
        """
        with self.writing():
            now = {*(one.person for one in submissions), *held}
            known = {}
            for row, person, digest in self._run("SELECT rowid, person, digest FROM submissions"):
                known[person] = digest
                if person not in now:
                    self._run("DELETE FROM submissions WHERE rowid = ?", row)
            for place, one in enumerate(submissions):
                if known.get(one.person) not in (None, one.digest):
                    self._run("DELETE FROM gradings WHERE person = ?", one.person)
                self._run(
                    "INSERT INTO submissions VALUES (?, ?, ?, ?, ?, ?) ON CONFLICT (person) DO UPDATE SET"
                    " name = excluded.name, place = excluded.place, source = excluded.source,"
                    " digest = excluded.digest, remarks = excluded.remarks",
                    *(one.person, one.name, place, one.source, one.digest, json.dumps(one.remarks)),
                )

    def record(self, graded: Graded, version: str, evidence: str | None) -> None:
        """Keep a grading, in place of an earlier one. It is on the disk when this returns."""
        unit, result = graded.unit, graded.result
        row = (
            *(unit.person, unit.exercise, now(), unit.attempt, result.verdict.value),
            *(result.points, result.max_points, result.containment, graded.seconds, result.timing.lag),
            *(version, evidence, to_json(result)),
        )
        with self.writing():
            self._run("DELETE FROM gradings WHERE person = ? AND exercise = ?", unit.person, unit.exercise)
            self._run(f"INSERT INTO gradings VALUES ({', '.join('?' * len(row))})", *row)
            for place, check in enumerate(result.checks):
                self._run(
                    "INSERT INTO checks VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
                    *(unit.person, unit.exercise, place, check.id, check.title, check.outcome.value),
                    *(check.earned, check.points, check.bonus),
                    check.feedback.summary if check.feedback else check.skipped_because,
                )

    def done(self) -> set[tuple[str, str]]:
        """Person and exercise of each grading, without our own errors and damaged ones."""
        every = ((one.unit, one.result.verdict) for one in self._every())
        return {(unit.person, unit.exercise) for unit, verdict in every if verdict is not Verdict.OUR_ERROR}

    def damaged(self) -> list[tuple[str, str]]:
        """Person and exercise of the gradings that can no longer be read."""
        return [(one.unit.person, one.unit.exercise) for one in self._every() if one.damaged]

    def drop_damaged(self) -> list[tuple[str, str]]:
        """Forget the damaged gradings, so that they are graded again; returns them."""
        dropped = self.damaged()
        with self.writing():
            for row in self._run(_KEYS):
                if self._stored(*row).damaged:
                    self._run("DELETE FROM gradings WHERE rowid = ?", row[0])
        return dropped

    def submissions(self) -> list[Submission]:
        rows = self._run("SELECT person, name, source, digest, remarks FROM submissions ORDER BY place")
        return [
            Submission(str(person), str(name), str(source), str(digest), _remarks(remarks))
            for person, name, source, digest, remarks in rows
        ]

    def gradings(self, person: str) -> list[StoredGrading]:
        """In the order of their exercises' ids. A damaged one is an error of ours; see `StoredGrading`."""
        rows = self._run(f"{_KEYS} WHERE person = ? ORDER BY exercise", person)
        return [self._stored(*row) for row in rows]

    def evidence(self) -> dict[tuple[str, str], str]:
        """Where recordings are, relative to the results' folder, by person and exercise."""
        return {(one.unit.person, one.unit.exercise): one.evidence for one in self._every() if one.evidence}

    def verdicts(self) -> dict[str, int]:
        """How many gradings ended with each verdict."""
        return dict(Counter(one.result.verdict.value for one in self._every()))

    def containments(self) -> tuple[str, ...]:
        return tuple(sorted({one.result.containment for one in self._every()} - {""}))

    def _every(self) -> Iterator[StoredGrading]:
        for row in self._run(f"{_KEYS} ORDER BY person, exercise"):
            yield self._stored(*row)

    def _stored(self, row: int, person: str, exercise: str) -> StoredGrading:
        """Read each one separately, so that damage to one does not affect the others."""
        statement = "SELECT attempt, result, evidence, seconds FROM gradings WHERE rowid = ?"
        try:
            ((attempt, text, evidence, seconds),) = self._run(statement, row)
            if isinstance(person, NoText):
                raise ValueError("it is nobody's")
            result = read_result(text, exercise)
            unit = Unit(person, exercise, int(attempt))
            return StoredGrading(unit, result, _path(evidence), float(seconds))
        except (DamagedData, ValueError, TypeError):
            found = damaged_result(str(exercise))
            return StoredGrading(Unit(str(person), str(exercise)), found, None, damaged=True)

    def forget(self, unit: Unit) -> None:
        """Remove its grading, as if it had never been graded."""
        with self.writing():
            self._run("DELETE FROM gradings WHERE person = ? AND exercise = ?", unit.person, unit.exercise)

    @contextlib.contextmanager
    def at_one_moment(self) -> Iterator[None]:
        """Everything read inside is from the same moment, even if others write."""
        self._run("BEGIN")
        try:
            yield
        finally:
            self._run("ROLLBACK")

    def _refusals(self) -> contextlib.AbstractContextManager[None]:
        return storage(Path(FILE))


class NoText(str):
    """A text in the file that is not UTF-8, as far as it can be read."""


def text_of(data: bytes) -> str:
    try:
        return data.decode()
    except UnicodeDecodeError:
        return NoText(data.decode(errors="replace"))


def read_result(text: object, exercise: str) -> Result:
    """Raises ValueError or DamagedData if `record` did not write this text for that exercise."""
    if isinstance(text, NoText) or not isinstance(text, str):
        raise ValueError("it is not text")
    result = from_json(text, "it")
    if result.exercise != exercise:
        raise ValueError(f"it is of {result.exercise}")
    return result


def damaged_result(exercise: str) -> Result:
    fault = Feedback(
        f"The record of this grading in {FILE} is damaged.",
        advice="Run the command that graded the class again: it grades this one again and keeps the others.",
    )
    return Result(exercise, Verdict.OUR_ERROR, fault=fault)


def _remarks(text: object) -> tuple[str, ...]:
    with contextlib.suppress(ValueError, RecursionError):
        found = json.loads(str(text))
        if isinstance(found, list):
            return tuple(map(str, found))
    return (f"The remarks stored in {FILE} are damaged.",)


def _path(evidence: object) -> str | None:
    if evidence is None:
        return None
    if not isinstance(evidence, str) or "\0" in evidence:
        raise ValueError("it is not a path")
    return evidence


def _make_ready(database: sqlite3.Connection, file: Path) -> None:
    database.execute("PRAGMA foreign_keys = ON")
    version, application = pragma(database, "user_version"), pragma(database, "application_id")
    tables = database.execute("SELECT COUNT(*) FROM sqlite_master").fetchone()[0]
    if (version, application, tables) == (0, 0, 0):
        begin(database, SCHEMA)
    elif application != APPLICATION:
        raise UsageError(f"{file} is not a file of ros2course.", _ELSEWHERE)
    elif version > SCHEMA_VERSION:
        raise UsageError(
            f"{file} was written by a newer ros2course.", "Use that version, or choose another folder."
        )


@contextlib.contextmanager
def storage(file: Path) -> Iterator[None]:
    """Say in an instructor's words what the disk or SQLite refused."""
    try:
        yield
    except (OSError, sqlite3.OperationalError) as error:
        raise StorageError(
            f"The results cannot be saved in {file}: {error}.", "Free some space, then run the command again."
        ) from error
    except (sqlite3.DatabaseError, UnicodeDecodeError) as error:  # SQLite's own message may be the damage
        raise DamagedData(f"{file} is damaged: {error}.", _ELSEWHERE) from error


_KEY = "asked"


class BatchSettings(Struct, frozen=True):
    """wanted: exercises as they were asked for. exercises: the ids that this meant. began: with a time zone.

    roster: a list of the whole class. title: of the assignment, as reports show it.
    complete: whether the course's own files were added to submissions that lack some.
    names: `strict`, or `lenient`: anything with another name was graded as if it had the right one.
    """

    submissions: Path
    wanted: tuple[str, ...]
    exercises: tuple[str, ...]
    single: bool
    contained: bool
    began: datetime
    roster: Path | None = None
    title: str = ""
    complete: bool = False
    names: str = "strict"


def keep_settings(results: Results, noted: BatchSettings) -> None:
    results.note(_KEY, codec.to_json(noted).decode())


def settings_of(results: Results) -> BatchSettings:
    """Raises UsageError if `grade` did not get as far as storing them."""
    text = results.noted(_KEY)
    if text is None and not results.submissions():  # submissions are written after it
        raise UsageError("Nothing has been graded there yet.", "Grade the class first.")
    try:
        return codec.from_json(text or "", BatchSettings, FILE)
    except DamagedData as error:
        step = "Run the command that graded the class again: it stores the request and keeps the results."
        raise StorageError(f"The request stored in {FILE} is damaged.", step) from error


_PEOPLE = "people"


def keep_people(results: Results, people: Sequence[Person], held: Sequence[str] = ()) -> None:
    """Store the times, the groups, and whose submission counts. held: as for `Results.enter`."""
    before = {one.id: one.renamed for one in people_of(results)}
    kept = [replace(one, renamed=before.get(one.id, ())) if one.id in held else one for one in people]
    results.note(_PEOPLE, codec.to_json(kept).decode())


_PACKED = "packed"


def keep_packed(results: Results, packed: Mapping[str, PackManifest], held: Sequence[str] = ()) -> None:
    """Store what `pack` wrote into submissions, by person. held: as for `Results.enter`."""
    texts = {person: text for person, text in _packed(results).items() if person in held}
    texts |= {person: codec.to_json(each).decode() for person, each in packed.items()}
    results.note(_PACKED, codec.to_json(texts).decode())


def packed_of(results: Results) -> dict[str, PackManifest]:
    """What `keep_packed` kept, for each person for whom it can still be read."""
    found = {}
    for person, text in _packed(results).items():
        with contextlib.suppress(DamagedData):
            found[person] = codec.from_json(text, PackManifest, FILE)
    return found


def _packed(results: Results) -> dict[str, str]:
    with contextlib.suppress(DamagedData):
        found: dict[str, str] = codec.from_json(results.noted(_PACKED) or "{}", dict[str, str], FILE)
        return found
    return {}


def people_of(results: Results) -> list[Person]:
    """Everybody in the order of the class, with what `keep_people` kept, as far as that can be read."""
    kept: dict[str, Person] = {}
    with contextlib.suppress(DamagedData):
        found = codec.from_json(results.noted(_PEOPLE) or "[]", list[Person], FILE)
        kept = {one.id: one for one in found}
    every = (Person(one.person, one.name) for one in results.submissions())
    return [replace(kept.get(one.id, one), name=one.name) for one in every]
