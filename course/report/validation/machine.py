"""What was found, for programs: JUnit XML for CI services, workflow commands for GitHub."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from datetime import datetime
from itertools import groupby

from course.feedback import Feedback, Location
from course.report.gradebook import annotations as github
from course.report.gradebook import junit
from course.report.gradebook.cleaning import Cleaner
from course.report.validation.model import Case, Note

FILES = "files"


def as_junit(name: str, began: datetime, cases: Sequence[Case], notes: Sequence[Note]) -> Iterator[str]:
    """A suite for each exercise, a case for each proof; what the files say wrong is a suite of its own.

    notes: those that no case has.
    """
    ordered = sorted(cases, key=lambda case: case.exercise)
    suites = [junit.Suite(FILES, tuple(_of_files(notes)))]
    for exercise, each in groupby(ordered, key=lambda case: case.exercise):
        suites.append(junit.Suite(exercise, tuple(map(_case, each))))
    return junit.document(name, began, lambda: suites)


def annotated(notes: Sequence[Note]) -> list[str]:
    """At most as many as GitHub shows, those with a line first. The file is relative to the repository."""
    ordered = sorted(notes, key=lambda note: note.line is None)
    return [_command(note) for note in ordered[: github.MOST]]


def _command(note: Note) -> str:
    told = _feedback(note)
    return github.command(note.exercise or "course", told, told.where[0])


def _of_files(notes: Sequence[Note]) -> Iterator[junit.Case]:
    for note in notes:
        yield junit.Case(FILES, f"{note.file}: {note.what}", "failure", "found", _feedback(note))
    if not notes:
        yield junit.Case(FILES, "what is written")


def _case(case: Case) -> junit.Case:
    if case.notes:
        kind, told = "failure", _feedback(case.notes[0])
    elif case.skipped is not None:
        kind, told = "skipped", Feedback(Cleaner().prose(case.skipped))
    else:
        return junit.Case(case.exercise, case.name, seconds=case.seconds)
    return junit.Case(case.exercise, case.name, kind, kind, told, case.seconds)


def _feedback(note: Note) -> Feedback:
    clean = Cleaner()
    step = clean.prose(note.next_step) if note.next_step else None
    return Feedback(clean.prose(note.what), where=(Location(note.file, note.line),), advice=step)
