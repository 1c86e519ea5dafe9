"""A class as it is at this moment, for those who look on while it is graded."""

from __future__ import annotations

import threading
from pathlib import Path

from course.batch.pages import ReadClass, of_one, read
from course.batch.results import FILE, Results
from course.content import Course
from course.report.page.data import as_json, submission_data
from course.report.page.html import live_page, news

# SQLite's file, and what has been written since it was put in order the last time.
_WRITTEN = (FILE, f"{FILE}-wal")


class Live:
    """Reads the results anew when they have changed. May be used by many threads."""

    def __init__(self, out: Path, course: Course) -> None:
        self._out = out
        self._course = course
        self._lock = threading.Lock()
        self._read: tuple[str, ReadClass] | None = None
        self._news: tuple[str, str] | None = None

    def page(self) -> str:
        with self._lock:
            return live_page(self._now()[1].page)

    def tag(self) -> str:
        """Another one whenever something was written."""
        stamps = []
        for name in _WRITTEN:
            try:
                seen = (self._out / name).stat()
                stamps.append(f"{seen.st_mtime_ns:x}.{seen.st_size:x}")
            except FileNotFoundError:
                stamps.append("none")
        return "-".join(stamps)

    def news(self) -> tuple[str, str]:
        """The tag, and as JSON what the page shows of the class."""
        with self._lock:
            tag, found = self._now()
            if self._news is None or self._news[0] != tag:
                self._news = tag, as_json(news(found.page))
            return self._news

    def submission(self, place: int) -> str | None:
        """As JSON; None when there is nobody at that place."""
        with self._lock:
            found = self._now()[1]
        if place >= len(found.page.sheets):
            return None
        return as_json(submission_data(of_one(found, place), place))

    def _now(self) -> tuple[str, ReadClass]:
        tag = self.tag()  # before reading: what is written meanwhile is news the next time
        if self._read is None or self._read[0] != tag:
            with Results.look(self._out) as results:
                self._read = tag, read(self._out, results, self._course)
        return self._read
