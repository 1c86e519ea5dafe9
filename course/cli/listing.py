"""`list`: chapters and exercises, and what was reached in each."""

from __future__ import annotations

from typing import TYPE_CHECKING

import typer

from course.cli.session import open_session
from course.cli.usage import examples
from course.report.console import open_console
from course.report.exercise_text import ExerciseRow, render_list

if TYPE_CHECKING:
    from course.content import Chapter, ChapterRef, Exercise
    from course.progress import Progress

EXAMPLES = examples(("list", "all exercises, with your progress"))


def list_(ctx: typer.Context) -> None:
    """List the exercises and your progress in each."""
    with open_session(ctx) as session:
        chapters = session.course.chapters()
        rows = [row_of(one, session.progress) for chapter in chapters for one in chapter.exercises]
        render_list(open_console(), rows, map(heading_of, chapters))


def heading_of(chapter: Chapter | ChapterRef) -> str:
    return f"{chapter.number} {chapter.title}"


def row_of(exercise: Exercise, progress: Progress) -> ExerciseRow:
    last = progress.last_result(exercise.id)
    return ExerciseRow(
        chapter=heading_of(exercise.chapter),
        exercise=exercise.id,
        title=f"{exercise.title} (bonus)" if exercise.bonus else exercise.title,
        state=progress.state(exercise.id),
        current=progress.current() == exercise.id,
        best=progress.best(exercise.id),
        most=last.max_points if last else None,
    )
