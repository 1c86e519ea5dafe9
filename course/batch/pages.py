"""A graded class for the page: read from the results, with pictures drawn from the recordings."""

from __future__ import annotations

import signal
import zlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, replace
from datetime import datetime, timezone
from functools import partial
from multiprocessing import get_context
from os import sched_getaffinity
from pathlib import Path

from course.arena.sandbox.linux import PR_SET_PDEATHSIG, process_control
from course.batch.gradebook import cleaner, gradebook
from course.batch.noted import noted
from course.batch.results import Results
from course.content import Course
from course.errors import StorageError
from course.evidence.mcap_file import BadRecording, load
from course.grading.result import Verdict
from course.report.gradebook.cleaning import Cleaner
from course.report.gradebook.sheets import exercises_of, sheets
from course.report.page.model import ClassPage, Key
from course.report.pictures.album import pictures

# What all pictures may take of the page, in bytes; deflated one by one and in base64. In it they take less,
# since the pictures of one person are alike.
PICTURES_ROOM = 8_000_000
TITLE = "ros2course"
_LABEL = 60
_PORTION = 16
# Fewer recordings than this are drawn before another process would have started.
_FEW = 100
_DRAWN_FIRST = (Verdict.NOT_PASSED.value,)

Progress = Callable[[int, int], None]


@dataclass(frozen=True)
class ReadClass:
    """page: without pictures. recordings: files, of those gradings that have one. clean: for their texts."""

    page: ClassPage
    recordings: Mapping[Key, Path]
    clean: Cleaner


def read(out: Path, results: Results, course: Course) -> ReadClass:
    """What is in the results' folder at this moment, also while it is being graded into.

    Raises UsageError when nothing has been graded there yet, StorageError when it cannot be read.
    """
    with results.at_one_moment():
        asked = noted(results)
        clean = cleaner(out, asked.submissions)
        exercises = [course.exercise(name) for name in asked.exercises]
        book = gradebook(results, TITLE, exercises, asked.began, datetime.now(timezone.utc))
        every = tuple(sheets(book, clean))
        page = ClassPage(book.course, exercises_of(book, clean), every, book.began, book.ended)
        return ReadClass(page, _recordings(out, results), clean)


def with_pictures(found: ReadClass, room: int, on_progress: Progress) -> ClassPage:
    """The page with as many pictures as there is room for, those of what did not pass first.

    on_progress: how many recordings of how many. Recordings that cannot be read have no pictures.
    """
    wanted = sorted(found.recordings, key=partial(_urgency, found.page))
    drawn: dict[Key, tuple[str, ...]] = {}
    used = done = 0
    with _drawing(found, wanted) as each:
        for done, (key, (pictures, size)) in enumerate(zip(wanted, each, strict=True), 1):
            if used + size > room:
                done -= 1
                break
            used += size
            drawn[key] = pictures
            on_progress(done, len(wanted))
    return replace(found.page, pictures=drawn, not_drawn=len(wanted) - done)


def of_one(found: ReadClass, place: int) -> ClassPage:
    """The page with the pictures of the person at that place alone."""
    own = {key: file for key, file in found.recordings.items() if key[0] == place}
    drawn = {key: _pictures(found.clean, key, file)[0] for key, file in own.items()}
    return replace(found.page, pictures=drawn)


def _recordings(out: Path, results: Results) -> dict[Key, Path]:
    places = {one.person: place for place, one in enumerate(results.submissions())}
    kept = results.evidence()
    return {(places[person], exercise): out / file for (person, exercise), file in kept.items()}


def _urgency(page: ClassPage, key: Key) -> tuple[bool, Key]:
    place, exercise = key
    verdicts = {mark.exercise.id: mark.verdict for mark in page.sheets[place].marks}
    return verdicts.get(exercise) not in _DRAWN_FIRST, key


@contextmanager
def _drawing(found: ReadClass, wanted: Sequence[Key]) -> Iterator[Iterator[tuple[tuple[str, ...], int]]]:
    """Pictures in the order in which they are wanted, and their size; drawn by several processes."""
    draw = partial(_pictures, found.clean)
    files = [found.recordings[key] for key in wanted]
    if len(wanted) < _FEW:
        yield map(draw, wanted, files)
        return
    cores = len(sched_getaffinity(0))
    pool = ProcessPoolExecutor(cores, mp_context=get_context("spawn"), initializer=_begin)
    try:
        yield pool.map(draw, wanted, files, chunksize=_PORTION)
    finally:
        pool.shutdown(cancel_futures=True)


def _begin() -> None:
    """These processes end with the one that began them, which ends them on Ctrl+C."""
    process_control(PR_SET_PDEATHSIG, signal.SIGKILL)
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def _pictures(clean: Cleaner, key: Key, file: Path) -> tuple[tuple[str, ...], int]:
    """And how large they will be in the page."""
    try:
        recording = load(file)
    except (BadRecording, StorageError):  # it may just be replaced; the verdict stands without it
        return (), 0
    place, exercise = key
    name = f"p{place}{''.join(filter(str.isalnum, exercise))}"
    drawn = pictures(recording, key=name, clean=partial(clean.line, limit=_LABEL))
    return drawn, len(zlib.compress("".join(drawn).encode())) * 4 // 3
