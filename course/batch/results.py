"""The results of a batch: one SQLite file, written as they come, one row per check.

Each grading is one transaction: it is there as a whole or not at all, whatever kills us. The file is in
WAL mode, so that others can look on.
"""

from __future__ import annotations

import contextlib
import json
import sqlite3
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from datetime import datetime, timezone
from pathlib import Path
from types import TracebackType

from course.batch.model import Graded, Unit
from course.errors import StorageError, UsageError
from course.grading.result import Result, from_json, to_json

FILE = "grades.sqlite3"
SCHEMA_VERSION = 1
APPLICATION = 0x726F7334
_BUSY_SECONDS = 10.0
_ELSEWHERE = "Name another folder with --out."
_SCHEMA = f"""
BEGIN IMMEDIATE;
CREATE TABLE batch (key TEXT PRIMARY KEY, value TEXT NOT NULL);
CREATE TABLE submissions (
    person TEXT PRIMARY KEY,
    name TEXT NOT NULL,
    place INTEGER NOT NULL,       -- in the order of the class
    source TEXT NOT NULL,         -- as it was handed in
    digest TEXT NOT NULL,         -- of what was found in it: another digest is graded anew
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
    result TEXT NOT NULL,         -- JSON, as course.grading.result writes it
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
    """A submission as it is kept. remarks: sentences about it as a whole."""

    person: str
    name: str
    source: str
    digest: str
    remarks: tuple[str, ...] = ()


@dataclass(frozen=True)
class Stored:
    """A grading as it is kept. evidence: relative to the results' folder, None if there is none."""

    unit: Unit
    result: Result
    evidence: str | None
    seconds: float = 0.0


class Results:
    """The file in one results folder. A context manager."""

    def __init__(self, database: sqlite3.Connection) -> None:
        self._database = database

    @classmethod
    def open(cls, folder: Path, *, create: bool = True) -> Results:
        """Raises StorageError for the disk, UsageError for a folder that is none of ours."""
        file = folder / FILE
        if not create and not file.is_file():
            raise UsageError(f"No results of `grade` are in {folder}.", "Name the folder given to --out.")
        with _storage(file):
            folder.mkdir(parents=True, exist_ok=True)
            database = sqlite3.connect(file, timeout=_BUSY_SECONDS, isolation_level=None)
            try:
                _make_ready(database, file)
            except BaseException:
                database.close()
                raise
        return cls(database)

    @classmethod
    def look(cls, folder: Path) -> Results:
        """For reading alone, also while somebody grades into it. Raises as `open` does."""
        results = cls.open(folder, create=False)
        results._run("PRAGMA query_only = ON")
        return results

    def __enter__(self) -> Results:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._database.close()

    def note(self, key: str, value: str) -> None:
        """Keep something about the batch as a whole."""
        with self._writing():
            self._run("INSERT OR REPLACE INTO batch VALUES (?, ?)", key, value)

    def noted(self, key: str) -> str | None:
        row = self._run("SELECT value FROM batch WHERE key = ?", key).fetchone()
        return row[0] if row else None

    def enter(self, submissions: Sequence[Submission]) -> None:
        """These are the submissions now. What was graded of one that has changed, or is gone, is dropped."""
        with self._writing():
            known = dict(self._run("SELECT person, digest FROM submissions").fetchall())
            for person in known.keys() - {one.person for one in submissions}:
                self._run("DELETE FROM submissions WHERE person = ?", person)
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
            *(unit.person, unit.exercise, _now(), unit.attempt, result.verdict.value),
            *(result.points, result.max_points, result.containment, graded.seconds, result.timing.lag),
            *(version, evidence, to_json(result)),
        )
        with self._writing():
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
        """Person and exercise of all that was graded, our own errors left out."""
        rows = self._run("SELECT person, exercise FROM gradings WHERE verdict <> 'our error'")
        return {(person, exercise) for person, exercise in rows}

    def submissions(self) -> list[Submission]:
        rows = self._run("SELECT person, name, source, digest, remarks FROM submissions ORDER BY place")
        return [
            Submission(person, name, source, digest, tuple(json.loads(remarks)))
            for person, name, source, digest, remarks in rows.fetchall()
        ]

    def gradings(self, person: str) -> list[Stored]:
        """In the order of their exercises' ids."""
        rows = self._run(
            "SELECT person, exercise, attempt, result, evidence, seconds FROM gradings"
            " WHERE person = ? ORDER BY exercise",
            person,
        )
        return [Stored(Unit(*row[:3]), _result(row[3]), row[4], row[5]) for row in rows.fetchall()]

    def evidence(self) -> dict[tuple[str, str], str]:
        """Where recordings are, relative to the results' folder, by person and exercise."""
        rows = self._run("SELECT person, exercise, evidence FROM gradings WHERE evidence IS NOT NULL")
        return {(person, exercise): file for person, exercise, file in rows}

    def verdicts(self) -> dict[str, int]:
        """How many gradings ended with each verdict."""
        return dict(self._run("SELECT verdict, COUNT(*) FROM gradings GROUP BY verdict").fetchall())

    def containments(self) -> tuple[str, ...]:
        rows = self._run("SELECT DISTINCT containment FROM gradings WHERE containment <> '' ORDER BY 1")
        return tuple(row[0] for row in rows.fetchall())

    def forget(self, unit: Unit) -> None:
        """As if it had not been graded."""
        with self._writing():
            self._run("DELETE FROM gradings WHERE person = ? AND exercise = ?", unit.person, unit.exercise)

    @contextlib.contextmanager
    def at_one_moment(self) -> Iterator[None]:
        """Whatever is read meanwhile is of the same moment, whoever writes."""
        self._run("BEGIN")
        try:
            yield
        finally:
            self._run("ROLLBACK")

    @contextlib.contextmanager
    def all_or_nothing(self) -> Iterator[None]:
        """Whatever is written meanwhile is there as a whole afterwards, or not at all."""
        with self._writing():
            yield

    @contextlib.contextmanager
    def _writing(self) -> Iterator[None]:
        if self._is_open():
            yield
            return
        with _storage(Path(FILE)):
            self._database.execute("BEGIN IMMEDIATE")
            try:
                yield
                self._database.execute("COMMIT")
            except BaseException:
                if self._is_open():  # a full disk has ended it already
                    self._database.execute("ROLLBACK")
                raise

    def _is_open(self) -> bool:
        """Whether a transaction is."""
        return self._database.in_transaction

    def _run(self, statement: str, *values: object) -> sqlite3.Cursor:
        with _storage(Path(FILE)):
            return self._database.execute(statement, values)


def _result(text: str) -> Result:
    try:
        return from_json(text)
    except (ValueError, KeyError) as error:
        raise StorageError(f"{FILE} is damaged: {error}.", _ELSEWHERE) from error


def _make_ready(database: sqlite3.Connection, file: Path) -> None:
    database.execute("PRAGMA foreign_keys = ON")
    version = database.execute("PRAGMA user_version").fetchone()[0]
    application = database.execute("PRAGMA application_id").fetchone()[0]
    tables = database.execute("SELECT COUNT(*) FROM sqlite_master").fetchone()[0]
    if (version, application, tables) == (0, 0, 0):
        database.execute("PRAGMA journal_mode = WAL")
        database.executescript(_SCHEMA)
    elif application != APPLICATION:
        raise UsageError(f"{file} is not a file of ros2course.", _ELSEWHERE)
    elif version > SCHEMA_VERSION:
        raise UsageError(f"{file} was written by a newer ros2course.", "Use that one, or another folder.")


@contextlib.contextmanager
def _storage(file: Path) -> Iterator[None]:
    try:
        yield
    except (OSError, sqlite3.OperationalError) as error:
        raise StorageError(
            f"The results cannot be kept in {file}: {error}.", "Make room, then go on."
        ) from error
    except sqlite3.DatabaseError as error:
        raise StorageError(f"{file} is damaged: {error}.", _ELSEWHERE) from error


def _now() -> str:
    return datetime.now(timezone.utc).isoformat(timespec="seconds")
