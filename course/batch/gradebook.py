"""The results of a batch as the reports want them: read from the file, one submission after another."""

from __future__ import annotations

import contextlib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from course.batch.results import Results, Stored
from course.batch.run import ANSWERS
from course.content import Exercise
from course.errors import CourseError
from course.grading.author import Grader
from course.grading.load import declared, load_module
from course.grading.result import Result
from course.home.model import is_home, read_marker
from course.report.gradebook.cleaning import Cleaner, places_here
from course.report.gradebook.model import Gradebook, Graded, GradedExercise, Person


@dataclass(frozen=True)
class _Class:
    results: Results

    def __iter__(self) -> Iterator[Graded]:
        for one in self.results.submissions():
            found: Iterable[Stored] = self.results.gradings(one.person)
            results: tuple[Result, ...] = tuple(stored.result for stored in found)
            yield Graded(Person(one.person, one.name), one.source, results, one.remarks)


def gradebook(
    results: Results, title: str, exercises: Iterable[Exercise], began: datetime, ended: datetime
) -> Gradebook:
    """Walked as often as a report likes; memory stays flat."""
    containment = ", ".join(results.containments())
    asked = tuple(graded_exercise(exercise) for exercise in exercises)
    return Gradebook(title, asked, _Class(results), began, ended, containment)


def graded_exercise(exercise: Exercise) -> GradedExercise:
    """With the points that can be had when everything applies."""
    module = load_module(exercise.grader) if exercise.grader.is_file() else None
    grader = declared(module, Grader, exercise.id) if module else None
    checks = sum(check.points for check in grader.checks.values() if not check.bonus) if grader else 0.0
    asked = sum(question.points for question in exercise.questions)
    return GradedExercise(exercise.id, exercise.title, checks + asked, exercise.bonus)


def cleaner(out: Path, submissions: Path) -> Cleaner:
    """Nothing of this machine or of a mystery goes into a report."""
    own = {str(out.resolve()): "[results]", str(submissions.resolve()): "[submissions]"}
    return Cleaner({**places_here(), **own}, tuple(_seeds(out / ANSWERS)))


def _seeds(answers: Path) -> Iterator[str]:
    for home in answers.glob("*/"):
        with contextlib.suppress(CourseError):  # whatever was handed in as one
            if is_home(home):
                yield str(read_marker(home))
