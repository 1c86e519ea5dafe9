"""Replaces a results' file that has damaged pages with a new one, made of all that can still be read.

SQLite reads around a damaged page, but cannot write there, so what was on it could not be graded again.
"""

from __future__ import annotations

import contextlib
import sqlite3
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from course.batch.results import FILE, SCHEMA, NoText, storage, text_of

KEPT_AS = "grades.damaged.sqlite3"
_TABLES = ("batch", "submissions", "gradings", "checks")
_LOST = "INSERT OR IGNORE INTO gradings VALUES (?, ?, '', 1, 'our error', 0, 0, '', 0, 0, '', NULL, '')"
Row = tuple[Any, ...]


def repair(folder: Path) -> bool:
    """Replace a damaged results' file, and keep the old one beside it as KEPT_AS; True if that was needed.

    Gradings of which only the keys can be read are damaged in the new one, too. Nobody else may use it.
    """
    file = folder / FILE
    if not file.is_file():
        return False
    with storage(file), contextlib.closing(sqlite3.connect(file)) as old:
        old.text_factory = text_of
        if _is_whole(old):
            return False
        beside = file.with_name(f"{FILE}.new")
        beside.unlink(missing_ok=True)
        with contextlib.closing(sqlite3.connect(beside)) as new:
            new.executescript(SCHEMA)
            _copy(old, new)
    with storage(file):
        file.replace(folder / KEPT_AS)
        for rest in ("-wal", "-shm"):
            file.with_name(FILE + rest).unlink(missing_ok=True)
        beside.replace(file)
    return True


def _is_whole(database: sqlite3.Connection) -> bool:
    """Also true for a file that is not our database: opening it reports that."""
    try:
        database.execute("SELECT COUNT(*) FROM gradings WHERE 0")
    except sqlite3.DatabaseError:
        return True
    try:
        return bool(database.execute("PRAGMA quick_check(1)").fetchone()[0] == "ok")
    except sqlite3.DatabaseError:
        return False


def _copy(old: sqlite3.Connection, new: sqlite3.Connection) -> None:
    new.execute("BEGIN")
    for table in _TABLES:
        for row in _readable(old, table):
            if not any(isinstance(value, NoText) for value in row):
                with contextlib.suppress(sqlite3.IntegrityError):
                    new.execute(f"INSERT INTO {table} VALUES ({', '.join('?' * len(row))})", row)
    with contextlib.suppress(sqlite3.DatabaseError):
        new.executemany(_LOST, old.execute("SELECT person, exercise FROM gradings").fetchall())
    new.execute("COMMIT")


def _readable(database: sqlite3.Connection, table: str) -> Iterator[Row]:
    """Read each row separately, so that a damaged page affects only its own rows."""
    for number in _numbers(database, table):
        with contextlib.suppress(sqlite3.DatabaseError):
            yield from database.execute(f"SELECT * FROM {table} WHERE rowid = ?", (number,)).fetchall()


def _numbers(database: sqlite3.Connection, table: str) -> Iterable[int]:
    """The row numbers in an index, or all possible ones."""
    try:
        rows = database.execute(f"SELECT rowid FROM {table} INDEXED BY sqlite_autoindex_{table}_1").fetchall()
        return [number for (number,) in rows]
    except sqlite3.DatabaseError:
        with contextlib.suppress(sqlite3.DatabaseError):
            return range(1, database.execute(f"SELECT MAX(rowid) FROM {table}").fetchone()[0] + 1)
    return ()
