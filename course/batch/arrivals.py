"""A folder in which submissions arrive: which of them are complete, and when there is something to do."""

from __future__ import annotations

import os
import threading
from collections.abc import Iterator, Mapping
from itertools import islice
from pathlib import Path
from time import monotonic

from course.batch.intake import Upload
from course.batch.intake.tree import is_results
from course.batch.intake.uploads import entries_of
from course.errors import UsageError
from course.home.storage import storing

# A submission counts as complete after this many seconds without a change.
QUIET = 5.0
# Seconds between two looks. Network drives do not report changes, so the folder is polled.
LOOK = 1.0
# The most files of one submission that are looked at; opening it has its own limits.
_MOST = 20_000

# For each entry of the folder, by name: its files, each with the time of its last change and its size.
Entries = Mapping[str, frozenset[tuple[str, int, int]]]


class Arrivals:
    """The entries of a folder, as they come.

    complete: the complete ones at the last look. fresh: those among them that are new or have changed since
    the look before. Raises UsageError if it is not a folder.
    """

    def __init__(self, folder: Path) -> None:
        if not folder.is_dir():
            raise UsageError(f"{folder} is not a folder, so nothing can arrive in it.", "Name a folder.")
        self._folder = folder
        self._since: dict[str, tuple[frozenset[tuple[str, int, int]], float]] = {}
        self.complete: Entries = {}
        self.fresh: frozenset[str] = frozenset()

    def wait(self) -> None:
        """Return as soon as a submission becomes complete, has changed, or is gone. A signal ends the wait.

        It keeps waiting as long as no submission at all is complete.
        """
        never = threading.Event()
        while not self._look() or not self.complete:
            never.wait(LOOK)

    def holds_back(self, upload: Upload) -> bool:
        """Whether part of it was still being written at the last look."""
        names = (part.path.name for part in upload.parts if part.path.parent == self._folder)
        return any(name not in self.complete for name in names)

    def forget_fresh(self) -> None:
        """Report the fresh ones again, once they have not changed for another QUIET seconds."""
        self._since = {name: since for name, since in self._since.items() if name not in self.fresh}
        self.complete = {name: files for name, files in self.complete.items() if name not in self.fresh}

    def _look(self) -> bool:
        with storing(f"{self._folder} cannot be read"):
            entries = entries_of(self._folder)
        began, before = monotonic(), self.complete
        seen = {entry.name: frozenset(islice(_states(entry), _MOST)) for entry in entries}
        now = monotonic()
        self._since = {name: (files, self._unchanged(name, files, now)) for name, files in seen.items()}
        # Only by our own clock: a network drive's may show any other time.
        quiet = {name for name, (_, since) in self._since.items() if began - since >= QUIET}
        self.complete = {name: files for name, files in seen.items() if files and name in quiet}
        self.fresh = frozenset(name for name, files in self.complete.items() if before.get(name) != files)
        return bool(self.fresh or before.keys() - seen.keys())

    def _unchanged(self, name: str, files: frozenset[tuple[str, int, int]], now: float) -> float:
        before, since = self._since.get(name, (None, now))
        return since if before == files else now


def _states(entry: Path) -> Iterator[tuple[str, int, int]]:
    yield from _state(str(entry))
    for folder, folders, files in os.walk(entry):
        folders[:] = [name for name in folders if not is_results(Path(folder, name))]
        for name in (*folders, *files):
            yield from _state(f"{folder}/{name}")


def _state(path: str) -> Iterator[tuple[str, int, int]]:
    try:
        state = os.lstat(path)
    except OSError:  # it is gone again, or may not be read
        return
    yield path, state.st_ctime_ns, state.st_size
