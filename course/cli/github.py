"""The output of `grade` for a step of GitHub Actions, if it runs in one.

GITHUB_STEP_SUMMARY  names the file that the job's summary is appended to
GITHUB_OUTPUT        names the file of the step's outputs: `result`, for Classroom's grading reporter
GITHUB_ACTIONS       is "true": annotations are lines on standard output
GITHUB_WORKSPACE     the clone that places in files are relative to
SUBMISSION_TAG, ...  the runner of Classroom 50 sets these: result.json goes into the clone

Source of the names: GitHub's documentation of workflow commands and default environment variables.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping
from datetime import datetime, timezone
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING

from course.batch.intake.commits import committed
from course.errors import StorageError
from course.files import write_pieces
from course.report.gradebook import github
from course.report.gradebook.github import job_summary
from course.report.gradebook.sheets import exercises_of, sheets

if TYPE_CHECKING:
    from course.batch.intake import Found
    from course.model.gradebook import Gradebook
    from course.report.gradebook.cleaning import Cleaner


def hand_over(
    book: Gradebook, clean: Cleaner, single: Found | None, submissions: Path, environ: Mapping[str, str]
) -> None:
    """single: the one submission, whose lines are annotated; None for a class. Raises StorageError."""
    if summary := environ.get("GITHUB_STEP_SUMMARY"):
        _summarise(Path(summary), book, clean)
    if single is None:
        return
    sheet = next(sheets(book, clean))
    if environ.get("GITHUB_ACTIONS") == "true":
        for line in github.commands(sheet, _in_repository(single, submissions, environ)):
            print(line)
    if output := environ.get("GITHUB_OUTPUT"):
        _append(Path(output), f"result={github.encoded(sheet)}\n")
    if all(environ.get(name) for name in github.SUBMISSION):
        clone = Path(environ.get("GITHUB_WORKSPACE") or submissions)
        now = datetime.now(timezone.utc)
        result = github.classroom50(sheet, environ, committed(clone / ".git") or now, now)
        write_pieces(clone / "result.json", [json.dumps(result, ensure_ascii=False, indent=2), "\n"])


def _summarise(file: Path, book: Gradebook, clean: Cleaner) -> None:
    used = file.stat().st_size if file.exists() else 0
    title, exercises = clean.prose(book.course), exercises_of(book, clean)
    _append(file, job_summary(title, exercises, sheets(book, clean), used=used))


def _append(file: Path, text: str) -> None:
    try:
        with file.open("a", encoding="utf-8") as stream:
            stream.write(text)
    except OSError as error:
        raise StorageError(f"{file} could not be written: {error.strerror}.") from error


def _in_repository(found: Found, submissions: Path, environ: Mapping[str, str]) -> Callable[[str], str]:
    """Translates a path in the course home to the path in the clone."""
    clone = Path(environ.get("GITHUB_WORKSPACE") or submissions)
    top = os.path.relpath(submissions, clone)

    def place(file: str) -> str:
        for laid in found.places:
            if laid.target is None:
                continue
            target = PurePosixPath(laid.target)
            if PurePosixPath(file).is_relative_to(target):
                inside = PurePosixPath(laid.source, PurePosixPath(file).relative_to(target))
                return PurePosixPath(top, inside).as_posix()
        return file

    return place
