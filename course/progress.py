"""What a learner has done: attempts, passes, hints seen, current exercise. One SQLite file in the home.

The file is in WAL mode, so that two checks at once are both stored. A damaged file is renamed and reported,
and a new one is begun. Our own errors are stored too, but never count as the learner's attempts.
"""

from __future__ import annotations

import contextlib
import os
import sqlite3
from collections.abc import Iterator
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from course.database import BUSY_SECONDS, Database, begin, now, pragma
from course.errors import DamagedData, StorageError, UsageError
from course.files import locked

if TYPE_CHECKING:
    from course.model.result import Result

State = Literal["new", "begun", "tried", "passed"]

FILE = "progress.sqlite3"
SCHEMA_VERSION = 1
APPLICATION = 0x726F7332  # "ros2", in the file's header: distinguishes our files from others

# The answers in reviews: `wrong` goes up with each wrong one, and down with each right one.
_REVIEWS = "CREATE TABLE reviews (exercise TEXT, question TEXT, wrong INT, PRIMARY KEY (exercise, question));"
_SCHEMA = f"""
BEGIN IMMEDIATE;
CREATE TABLE attempts (
    id INTEGER PRIMARY KEY,
    exercise TEXT NOT NULL,
    at TEXT NOT NULL,            -- UTC, ISO 8601; so are the other times
    verdict TEXT NOT NULL,
    counts INTEGER NOT NULL,     -- 0: our error, or not available here
    points REAL NOT NULL,
    max_points REAL NOT NULL,
    result TEXT NOT NULL         -- JSON, as course.model.result writes it
);
CREATE INDEX attempts_of_exercise ON attempts (exercise, counts);
CREATE TABLE exercises (
    exercise TEXT PRIMARY KEY,
    begun_at TEXT,
    passed_at TEXT,              -- the first pass; what is passed stays passed
    hints INTEGER NOT NULL DEFAULT 0
);
CREATE TABLE chapters_shown (slug TEXT PRIMARY KEY, at TEXT NOT NULL);
CREATE TABLE current (one INTEGER PRIMARY KEY CHECK (one = 1), exercise TEXT NOT NULL);
{_REVIEWS}
PRAGMA application_id = {APPLICATION};
PRAGMA user_version = {SCHEMA_VERSION};
COMMIT;
"""


class Progress(Database):
    """The progress stored in one course home. A context manager. `notices` says what happened to the file."""

    def __init__(self, database: sqlite3.Connection, notices: tuple[str, ...] = ()) -> None:
        super().__init__(database)
        self.notices = notices

    @classmethod
    def open(cls, state: Path) -> Progress:
        """Open the file in a home's `state` folder, or begin one.

        Raises StorageError when it cannot be read or written, UsageError when a newer ros2course wrote it.
        """
        # Two processes must not both begin a file, or both set one aside.
        with _storage(), locked(state / "progress.lock"):
            return cls(*_open(state / FILE))

    def record(self, result: Result) -> None:
        """Store a result; if it passed, mark the exercise as passed. It is on the disk when this returns."""
        from course.model.result import Verdict, to_json  # `hint` and `list` do not need it

        counts = result.verdict in (Verdict.PASSED, Verdict.NOT_PASSED)
        row = (result.exercise, now(), result.verdict.value, counts, result.points, result.max_points)
        with self.writing():
            self._run(
                "INSERT INTO attempts (exercise, at, verdict, counts, points, max_points, result)"
                " VALUES (?, ?, ?, ?, ?, ?, ?)",
                *row,
                to_json(result),
            )
            if result.verdict is Verdict.PASSED:
                self._stamp(result.exercise, "passed_at")

    def state(self, exercise: str) -> State:
        """An exercise that was passed stays passed, whatever the result of later attempts."""
        row = self._one("SELECT begun_at, passed_at FROM exercises WHERE exercise = ?", exercise)
        begun, passed = row or (None, None)
        if passed:
            return "passed"
        if self.attempts(exercise):
            return "tried"
        return "begun" if begun else "new"

    def attempts(self, exercise: str) -> int:
        """How often it was checked, not counting attempts that ended in our own error."""
        return int(self._value("SELECT count(*) FROM attempts WHERE exercise = ? AND counts", exercise) or 0)

    def best(self, exercise: str) -> float | None:
        """The most points of all attempts; None before the first."""
        points = self._value("SELECT max(points) FROM attempts WHERE exercise = ? AND counts", exercise)
        return None if points is None else float(points)

    def last_result(self, exercise: str) -> Result | None:
        """The result of the last attempt that counts; None if there is none that can still be read."""
        from course.model.result import from_json  # as above

        text = self._value(
            "SELECT result FROM attempts WHERE exercise = ? AND counts ORDER BY id DESC LIMIT 1", exercise
        )
        try:
            return None if text is None else from_json(text)
        except DamagedData:  # in the form of another version
            return None

    def failures(self) -> dict[tuple[str, str], int]:
        """How often each check failed, by exercise and check, in the results that can still be read.

        A wrong answer in a review counts, too; a right one cancels a failure.
        """
        from course.model.result import Outcome, from_json  # as above

        found: dict[tuple[str, str], int] = {}
        for exercise, text in self._run("SELECT exercise, result FROM attempts WHERE counts"):
            with contextlib.suppress(DamagedData):  # in the form of another version
                for check in from_json(text).checks:
                    if check.outcome is Outcome.FAILED:
                        found[exercise, check.id] = found.get((exercise, check.id), 0) + 1
        for exercise, question, wrong in self._run("SELECT exercise, question, wrong FROM reviews"):
            found[exercise, question] = max(0, found.get((exercise, question), 0) + wrong)
        return found

    def record_review(self, exercise: str, question: str, *, right: bool) -> None:
        """Store whether a question was answered right in a review."""
        row = (exercise, question, -1 if right else 1)
        with self.writing():
            self._run(
                "INSERT INTO reviews (exercise, question, wrong) VALUES (?, ?, ?)"
                " ON CONFLICT (exercise, question) DO UPDATE SET wrong = wrong + excluded.wrong",
                *row,
            )

    def passed_ids(self) -> frozenset[str]:
        return frozenset(
            row[0] for row in self._run("SELECT exercise FROM exercises WHERE passed_at NOTNULL")
        )

    def current(self) -> str | None:
        """The id of the exercise that `next` opened last."""
        exercise = self._value("SELECT exercise FROM current")
        return None if exercise is None else str(exercise)

    def set_current(self, exercise: str) -> None:
        """Also marks the exercise as begun."""
        with self.writing():
            self._run("INSERT OR REPLACE INTO current (one, exercise) VALUES (1, ?)", exercise)
            self._stamp(exercise, "begun_at")

    def next_hint(self, exercise: str, total: int) -> int:
        """Index of the hint to show now, from 0. Each call moves on by one, until the last hint."""
        if total < 1:
            raise ValueError("an exercise without hints has no next one")
        with self.writing():
            shown = min(self._hints(exercise) + 1, total)
            self._run(
                "INSERT INTO exercises (exercise, hints) VALUES (?, ?)"
                " ON CONFLICT (exercise) DO UPDATE SET hints = excluded.hints",
                exercise,
                shown,
            )
        return shown - 1

    def hints_shown(self, exercise: str) -> int:
        with _storage():
            return self._hints(exercise)

    def chapter_shown(self, slug: str) -> bool:
        """Whether the chapter's text was shown."""
        return self._value("SELECT 1 FROM chapters_shown WHERE slug = ?", slug) is not None

    def mark_chapter_shown(self, slug: str) -> None:
        with self.writing():
            self._run("INSERT OR IGNORE INTO chapters_shown (slug, at) VALUES (?, ?)", slug, now())

    def _hints(self, exercise: str) -> int:
        return int(self._value("SELECT hints FROM exercises WHERE exercise = ?", exercise) or 0)

    def _stamp(self, exercise: str, column: Literal["begun_at", "passed_at"]) -> None:
        self._run("INSERT OR IGNORE INTO exercises (exercise) VALUES (?)", exercise)
        self._run(
            f"UPDATE exercises SET {column} = coalesce({column}, ?) WHERE exercise = ?", now(), exercise
        )

    def _refusals(self) -> contextlib.AbstractContextManager[None]:
        return _storage()

    def _one(self, query: str, *values: object) -> tuple[Any, ...] | None:
        rows = self._run(query, *values)
        return rows[0] if rows else None

    def _value(self, query: str, *values: object) -> Any:
        row = self._one(query, *values)
        return row[0] if row else None


class _Damaged(Exception):
    """The file is not ours, or not complete."""


def _open(file: Path) -> tuple[sqlite3.Connection, tuple[str, ...]]:
    try:
        return _usable(file), ()
    except _Damaged:
        aside = _set_aside(file)
        notice = f"The record of your progress was damaged. It is kept as {aside}; a new one was started."
        return _usable(file), (notice,)


def _usable(file: Path) -> sqlite3.Connection:
    """A connection to a complete file of our schema. Raises _Damaged if it is neither that nor empty."""
    database = _connect(file)
    try:
        _prepare(database)
    except BaseException as error:
        database.close()
        if type(error) is sqlite3.DatabaseError:  # "malformed", "not a database"; a full disk is a subclass
            raise _Damaged(str(error)) from error
        raise
    return database


def _connect(file: Path) -> sqlite3.Connection:
    database = sqlite3.connect(file, timeout=BUSY_SECONDS, isolation_level=None)
    try:
        database.execute("PRAGMA user_version")
    except sqlite3.OperationalError:
        _leave_wal(database)
    except sqlite3.DatabaseError:
        pass  # damaged: the next reader says so
    return database


def _leave_wal(database: sqlite3.Connection) -> None:
    """Convert a home that was moved to a network disk without shared memory, which WAL needs."""
    try:
        database.execute("PRAGMA locking_mode = EXCLUSIVE")  # works without shared memory
        database.execute("PRAGMA journal_mode = DELETE")
        database.execute("PRAGMA locking_mode = NORMAL")
        database.execute("SELECT count(*) FROM sqlite_master").fetchall()  # releases the lock
    except BaseException:
        database.close()
        raise


def _prepare(database: sqlite3.Connection) -> None:
    version = pragma(database, "user_version")
    tables = {row[0] for row in database.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
    if version == 0 and not tables:
        begin(database, _SCHEMA)
        return
    if pragma(database, "application_id") != APPLICATION:
        raise _Damaged("a database of something else")
    if version > SCHEMA_VERSION:
        raise UsageError(
            f"your progress was saved by a newer ros2course (format {version})",
            "upgrade ros2course, then try again; your progress is left as it is",
        )
    if version != SCHEMA_VERSION or _TABLES - tables or pragma(database, "quick_check(1)") != "ok":
        raise _Damaged("not whole")
    if "reviews" not in tables:  # the file is of an older version
        database.execute(_REVIEWS)


_TABLES = frozenset({"attempts", "exercises", "chapters_shown", "current"})


def _set_aside(file: Path) -> Path:
    """Rename the file and its journals to unused names, and return the new name."""
    stamp, number = f"{datetime.now():%Y-%m-%dT%H-%M-%S}", 1
    aside = file.with_name(f"progress.damaged-{stamp}.sqlite3")
    while os.path.lexists(aside):
        number += 1
        aside = file.with_name(f"progress.damaged-{stamp}-{number}.sqlite3")
    for suffix in ("-wal", "-shm", "-journal", ""):
        with contextlib.suppress(FileNotFoundError):
            Path(f"{file}{suffix}").rename(f"{aside}{suffix}")
    return aside


@contextlib.contextmanager
def _storage() -> Iterator[None]:
    try:
        yield
    except OSError as error:
        what = f"your progress cannot be saved ({error.strerror or error}: {error.filename})"
        raise StorageError(what, _advice(str(error))) from error
    except sqlite3.DatabaseError as error:
        raise StorageError(f"your progress cannot be saved ({error})", _advice(str(error))) from error


def _advice(error: str) -> str:
    said = error.lower()
    if "full" in said or "no space" in said:
        return "free some space on this disk, then try again; what was saved before is still there"
    if "readonly" in said or "read-only" in said or "permission" in said or "unable to open" in said:
        return "make the course home writable for you; what was saved before is still there"
    if "locked" in said:
        return "another ros2course is busy with it: wait until it has ended, then try again"
    return "check the disk of the course home, then try again"
