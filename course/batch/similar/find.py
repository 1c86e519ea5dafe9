"""From a class to its pairs that are alike: reads every submission, then compares them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from enum import Enum
from pathlib import Path

from course.batch.similar.compare import Wanted, compare
from course.batch.similar.fingerprints import fingerprinter
from course.batch.similar.gather import HandedIn, gather
from course.batch.similar.given import given_of, solutions_of
from course.batch.similar.reading import Reader
from course.batch.similar.work import Work, work_of
from course.content import Course
from course.errors import UsageError
from course.home.opening import Finding
from course.report.similar.model import Comparison

Say = Callable[[str], None]


class Solutions(Enum):
    """What the course's own solutions are here."""

    ALONE = "left alone"
    COMPARED = "compared too, as if somebody had handed them in"
    GIVEN = "given, as starters are: what stands in them counts for nobody"


def find_similar(
    submissions: Path, opened: Path, course: Course, wanted: Wanted, solutions: Solutions, on_progress: Say
) -> Comparison:
    """submissions: as for `find_sources`. opened: a folder for archives, needed until this returns.

    Raises MissingHere without the library, UsageError when there are no two to compare, and StorageError.
    """
    reading = _Reading(course, solutions, on_progress)
    works = reading.works(submissions, opened)
    own = [work for work in works if work.words]
    if len(works) < 2:
        raise UsageError("There are no two submissions to compare.", "Name the folder that holds them all.")
    if solutions is Solutions.COMPARED:
        own += reading.solutions()
    pairs, more = compare(own, wanted, on_progress)
    return Comparison(
        pairs=pairs,
        compared=sum(not work.ours for work in own),
        threshold=wanted.share,
        more=more,
        without=tuple(work.name for work in works if not work.words),
        remarks=tuple(reading.remarks),
    )


class _Reading:
    """remarks: what was left out, and whose it is."""

    def __init__(self, course: Course, solutions: Solutions, say: Say) -> None:
        self._fingerprinter = fingerprinter()  # first: without the library, nothing needs to be read
        self.remarks: list[str] = []
        self._course = course
        self._say = say
        self._reader = Reader()
        self._given = given_of(course, self._reader, solutions=solutions is Solutions.GIVEN)

    def works(self, submissions: Path, opened: Path) -> list[Work]:
        found = gather(submissions, opened, self._course.exercises())
        return list(self._each(found))

    def solutions(self) -> list[Work]:
        handed_in = (HandedIn(name, tuple(files)) for name, files in solutions_of(self._course).items())
        return [work for work in (self._work(one, ours=True) for one in handed_in) if work.words]

    def _each(self, found: Iterator[HandedIn]) -> Iterator[Work]:
        for number, one in enumerate(found, 1):
            self._say(f"Reading submission {number}")
            yield self._work(one)

    def _work(self, one: HandedIn, *, ours: bool = False) -> Work:
        read, findings = self._reader.read(one.files)
        self.remarks += (_remark(one.name, finding) for finding in (*one.findings, *findings))
        return work_of(one.name, read, self._given, self._fingerprinter, ours=ours)


def _remark(name: str, finding: Finding) -> str:
    return f"{name}: {finding.what}{f' ({finding.where})' if finding.where else ''}"
