"""Our SQLite files: a change is stored completely or not at all, even if other processes use the file."""

from __future__ import annotations

import contextlib
import sqlite3
from collections.abc import Iterator
from datetime import datetime, timezone
from types import TracebackType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from typing_extensions import Self

BUSY_SECONDS = 10.0


class Database:
    """A context manager that closes the file. Subclasses turn errors into their own in `_refusals`."""

    def __init__(self, database: sqlite3.Connection) -> None:
        self._database = database

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._database.close()

    def _refusals(self) -> contextlib.AbstractContextManager[None]:
        """Turns errors of the disk and of SQLite into ours."""
        raise NotImplementedError

    def _run(self, statement: str, *values: object) -> list[Any]:
        """All rows at once, so that read errors are raised here."""
        with self._refusals():
            return self._database.execute(statement, values).fetchall()

    @contextlib.contextmanager
    def writing(self) -> Iterator[None]:
        """A transaction (all or nothing), or part of one that is open; waits for other writers."""
        if self._is_writing():
            yield
            return
        with self._refusals():
            self._database.execute("BEGIN IMMEDIATE")
            try:
                yield
                self._database.execute("COMMIT")
            finally:
                if self._is_writing():  # after an error; a full disk has already rolled it back
                    self._database.execute("ROLLBACK")

    def _is_writing(self) -> bool:
        return self._database.in_transaction


def begin(database: sqlite3.Connection, schema: str) -> None:
    """Make the tables in an empty file. Others can read it while one process writes."""
    with contextlib.suppress(sqlite3.OperationalError):  # a disk without shared memory: plain journal
        database.execute("PRAGMA journal_mode = WAL")
    if pragma(database, "journal_mode") != "wal":
        database.execute("PRAGMA journal_mode = DELETE")
    database.executescript(schema)


def pragma(database: sqlite3.Connection, name: str) -> Any:
    return database.execute(f"PRAGMA {name}").fetchone()[0]


def now() -> str:
    """UTC, ISO 8601."""
    return datetime.now(timezone.utc).isoformat(timespec="seconds")
