"""A graded class as reports and the page need it, with pictures drawn from the recordings."""

from __future__ import annotations

import contextlib
import signal
import threading
import zlib
from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, field
from datetime import datetime, timezone
from functools import partial
from multiprocessing import get_context
from os import sched_getaffinity
from pathlib import Path

from course.batch.deadlines import FILE as DEADLINES
from course.batch.intake.packed import differences
from course.batch.marks import FILE as MARKS
from course.batch.marks import NONE, Decisions, read_decisions
from course.batch.results import FILE, Results, StoredGrading, packed_of, people_of, settings_of
from course.batch.run import ANSWERS
from course.child import end_with_parent
from course.content import Course, Exercise
from course.errors import CourseError, StorageError
from course.evidence.mcap_file import BadRecording, load
from course.evidence.recording import Recording
from course.grading.author import Grader
from course.grading.load import declared, load_module
from course.home.course_home import is_home, read_marker
from course.model import replace
from course.model.gradebook import Gradebook, GradedExercise, GradedSubmission, HandMark, Person
from course.model.result import Result, Verdict
from course.report.gradebook.cleaning import Cleaner, places_here
from course.report.gradebook.sheets import exercises_of, sheets
from course.report.page.data import ClassPage, Code, Key, as_json, places_of, submission_data
from course.report.page.html import live_page, news
from course.report.pictures.timeline_svg import pictures


@dataclass(frozen=True)
class _Class:
    results: Results
    decisions: Decisions

    def __iter__(self) -> Iterator[GradedSubmission]:
        packed = packed_of(self.results)
        renamed = {person.id: person.renamed for person in people_of(self.results)}
        for one, person in zip(self.results.submissions(), people_of(self.results), strict=True):
            found: Iterable[StoredGrading] = self.results.gradings(person.graded_as or person.id)
            results: tuple[Result, ...] = tuple(stored.result for stored in found)
            lateness = self.decisions.lateness(person, handed_in=bool(one.source))
            marks = self.decisions.marks.get(person.id, ())
            given = {mark.exercise for mark in marks if mark.points is not None and not mark.check}
            named = (one for one in renamed.get(person.graded_as or person.id, ()) if one not in given)
            marks = (*(replace(OTHER_NAME, exercise=exercise) for exercise in named), *marks)
            theirs = packed.get(person.graded_as or person.id)
            remarks = (*one.remarks, *(differences(theirs, results) if theirs else ()))
            yield GradedSubmission(person, one.source, results, remarks, marks, lateness)


def gradebook(
    results: Results,
    title: str,
    exercises: Iterable[Exercise],
    began: datetime,
    ended: datetime,
    decisions: Decisions = NONE,
) -> Gradebook:
    """A gradebook that can be iterated as often as needed; memory use stays flat."""
    containment = ", ".join(results.containments())
    asked = tuple(graded_exercise(exercise) for exercise in exercises)
    return Gradebook(title, asked, _Class(results, decisions), began, ended, containment)


def decisions_in(out: Path, people: Iterable[Person], exercises: Iterable[Exercise]) -> Decisions:
    """What people decided in that results' folder. Raises UsageError, which names the lines."""
    # The ids of checks are in the graders, which nothing else here needs to load.
    checks = {one.id: check_ids(one) for one in exercises} if (out / MARKS).is_file() else {}
    return read_decisions(out, people, checks)


def check_ids(exercise: Exercise) -> tuple[str, ...]:
    """The ids of its checks and questions."""
    checks = grader.checks if (grader := _grader(exercise)) else ()
    return (*checks, *(question.id for question in exercise.questions))


def _grader(exercise: Exercise) -> Grader | None:
    module = load_module(exercise.grader) if exercise.grader.is_file() else None
    return declared(module, Grader, exercise.id) if module else None


def graded_exercise(exercise: Exercise) -> GradedExercise:
    """The exercise with its highest possible points, if every check applies."""
    grader = _grader(exercise)
    checks = sum(check.points for check in grader.checks.values() if not check.bonus) if grader else 0.0
    asked = sum(question.points for question in exercise.questions)
    return GradedExercise(exercise.id, exercise.title, checks + asked, exercise.bonus)


def cleaner(out: Path, submissions: Path) -> Cleaner:
    """Removes paths of this machine and seeds of mysteries from the texts of a report."""
    own = {str(out.resolve()): "[results]", str(submissions.resolve()): "[submissions]"}
    return Cleaner({**places_here(), **own}, tuple(_seeds(out / ANSWERS)))


def _seeds(answers: Path) -> Iterator[str]:
    for home in answers.glob("*/"):
        with contextlib.suppress(CourseError):  # it may be anything that was handed in as a home
            if is_home(home):
                yield str(read_marker(home))


# The most bytes of the page for all pictures, if each is compressed alone and written in base64. In the page
# they take less, since the pictures of one person are alike.
PICTURES_ROOM = 8_000_000
TITLE = "ros2course"
OTHER_NAME = HandMark(bonus=-1, comment="Graded as if named correctly.", label="Names")
_LABEL = 60
_PORTION = 16
# Fewer recordings than this are drawn before another process would have started.
_FEW = 100
_DRAWN_FIRST = (Verdict.NOT_PASSED.value,)

Progress = Callable[[int, int], None]


@dataclass(frozen=True)
class ReadClass:
    """page: without pictures. recordings: the files of gradings that have one. clean: for their texts.

    asked: by exercise, the files that the learner has to write.
    """

    page: ClassPage
    recordings: Mapping[Key, Path]
    clean: Cleaner
    asked: Mapping[str, tuple[str, ...]]

    def written(self, key: Key) -> Mapping[str, str]:
        """The files that were judged, by path; empty if there is no readable recording."""
        file = self.recordings.get(key)
        recording = _loaded(file) if file else None
        return recording.sources.files if recording else {}

    def drawn(self, key: Key) -> _Drawn:
        place, exercise = key
        marks = (mark for mark in self.page.sheets[place].marks if mark.exercise.id == exercise)
        found = {file for mark in marks for file, _, _ in places_of(mark)}
        return _drawn(self.clean, key, self.recordings[key], {*self.asked.get(exercise, ()), *found})


def read_class(out: Path, results: Results, course: Course, title: str = "") -> ReadClass:
    """What is in the results' folder at this moment, even while somebody is grading into it.

    Raises UsageError if nothing has been graded there yet, StorageError if it cannot be read.
    """
    with results.at_one_moment():
        settings = settings_of(results)
        clean = cleaner(out, settings.submissions)
        exercises = [course.exercise(name) for name in settings.exercises]
        decisions = decisions_in(out, people_of(results), exercises)
        ended = datetime.now(timezone.utc)
        shown = clean.prose(title or settings.title or TITLE)
        book = gradebook(results, shown, exercises, settings.began, ended, decisions)
        every = tuple(sheets(book, clean))
        page = ClassPage(book.course, exercises_of(book, clean), every, book.began, book.ended)
        asked = {exercise.id: exercise.files for exercise in exercises}
        return ReadClass(page, _recordings(out, results), clean, asked)


def with_pictures(found: ReadClass, room: int, on_progress: Progress) -> ClassPage:
    """The page with as much code and as many pictures as fit, beginning with what did not pass.

    on_progress: gets the numbers of recordings drawn and wanted. Unreadable recordings have no pictures.
    """
    wanted = sorted(found.recordings, key=partial(_urgency, found.page))
    every: dict[Key, _Drawn] = {}
    used = done = 0
    with _drawing(found, wanted) as each:
        for done, (key, drawn) in enumerate(zip(wanted, each, strict=True), 1):
            if used + drawn.size > room:
                done -= 1
                break
            used += drawn.size
            every[key] = drawn
            on_progress(done, len(wanted))
    return replace(_with(found.page, every), not_drawn=len(wanted) - done)


def _with(page: ClassPage, every: Mapping[Key, _Drawn]) -> ClassPage:
    pictures = {key: drawn.pictures for key, drawn in every.items()}
    return replace(page, pictures=pictures, code={key: drawn.code for key, drawn in every.items()})


def of_one(found: ReadClass, place: int) -> ClassPage:
    """The page with the pictures of only the person at that place."""
    return _with(found.page, {key: found.drawn(key) for key in found.recordings if key[0] == place})


def _recordings(out: Path, results: Results) -> dict[Key, Path]:
    places = {one.person: place for place, one in enumerate(results.submissions())}
    kept = results.evidence()
    return {(places[person], exercise): out / file for (person, exercise), file in kept.items()}


def _urgency(page: ClassPage, key: Key) -> tuple[bool, Key]:
    place, exercise = key
    verdicts = {mark.exercise.id: mark.verdict for mark in page.sheets[place].marks}
    return verdicts.get(exercise) not in _DRAWN_FIRST, key


@contextmanager
def _drawing(found: ReadClass, wanted: Sequence[Key]) -> Iterator[Iterator[_Drawn]]:
    """The wanted drawings, in order. Several processes make them if there are many."""
    if len(wanted) < _FEW:
        yield map(found.drawn, wanted)
        return
    cores = len(sched_getaffinity(0))
    pool = ProcessPoolExecutor(cores, mp_context=get_context("spawn"), initializer=_begin)
    try:
        yield pool.map(found.drawn, wanted, chunksize=_PORTION)
    finally:
        pool.shutdown(cancel_futures=True)


def _begin() -> None:
    """A worker ends with its parent, which handles Ctrl+C."""
    end_with_parent()
    signal.signal(signal.SIGINT, signal.SIG_IGN)


@dataclass(frozen=True)
class _Drawn:
    """What the page shows of a recording. size: how many bytes that takes in the page."""

    pictures: tuple[str, ...] = ()
    code: Code = field(default_factory=dict)
    size: int = 0


def _loaded(file: Path) -> Recording | None:
    with contextlib.suppress(BadRecording, StorageError):  # `grade` may be replacing it; the verdict stays
        return load(file)
    return None


def _drawn(clean: Cleaner, key: Key, file: Path, shown: Container[str]) -> _Drawn:
    recording = _loaded(file)
    if recording is None:
        return _Drawn()
    place, exercise = key
    name = f"p{place}{''.join(filter(str.isalnum, exercise))}"
    drawn = pictures(recording, key=name, clean=partial(clean.line, limit=_LABEL))
    texts = recording.sources.files if drawn else {}
    code = {clean.line(path): clean.code(text) for path, text in texts.items() if path in shown}
    together = "".join((*drawn, *(line for lines in code.values() for line in lines)))
    return _Drawn(drawn, code, len(zlib.compress(together.encode())) * 4 // 3)


# SQLite's file, its write-ahead log, and what people decided.
_WRITTEN = (FILE, f"{FILE}-wal", MARKS, DEADLINES)


class Live:
    """Reads the results again when they have changed. May be used by many threads."""

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
        """A text that changes whenever something is written."""
        stamps = []
        for name in _WRITTEN:
            try:
                seen = (self._out / name).stat()
                stamps.append(f"{seen.st_mtime_ns:x}.{seen.st_size:x}")
            except FileNotFoundError:
                stamps.append("none")
        return "-".join(stamps)

    def news(self) -> tuple[str, str]:
        """The tag, and what the page shows of the class, as JSON."""
        with self._lock:
            tag, found = self._now()
            if self._news is None or self._news[0] != tag:
                self._news = tag, as_json(news(found.page))
            return self._news

    def submission(self, place: int) -> str | None:
        """The submission at that place as JSON; None if there is none."""
        with self._lock:
            found = self._now()[1]
        if place >= len(found.page.sheets):
            return None
        return as_json(submission_data(of_one(found, place), place))

    def _now(self) -> tuple[str, ReadClass]:
        tag = self.tag()  # before reading: what is written meanwhile is news the next time
        if self._read is None or self._read[0] != tag:
            with Results.look(self._out) as results:
                self._read = tag, read_class(self._out, results, self._course)
        return self._read
