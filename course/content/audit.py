"""Everything that is wrong with a course folder, at once: what its author runs before anyone else does.

A command of a learner stops at the first error in the chapter that it needs; this goes through all files,
and through what only several of them together can tell.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from course.content import layout
from course.content.chapter import read_text
from course.content.document import Document
from course.content.lesson import LessonReading, read_lesson
from course.content.names import did_you_mean
from course.content.proof_problems import proof_problems
from course.content.requires import requires_problems
from course.errors import ContentError


def audit(root: Path) -> tuple[ContentError, ...]:
    """All problems of the course in `root`, by file and line; empty when it is right."""
    folders = layout.chapter_folders(root)
    readings = {folder: read_lesson(folder) for folder in folders}
    found = [problem for reading in readings.values() for problem in reading.problems]
    found += _same_number(folders)
    found += requires_problems(readings.values())
    for folder, reading in readings.items():
        if reading.data is not None:
            ids = tuple(exercise["id"] for exercise in reading.data["exercises"])
            found += [*_text_problems(folder, ids), *_strays(folder, ids)]
            found += [*_grader_and_solution(folder, reading), *proof_problems(folder, ids)]
    return tuple(sorted(found, key=lambda problem: (str(problem.file), problem.line or 0)))


def _same_number(folders: tuple[Path, ...]) -> Iterator[ContentError]:
    first: dict[str, Path] = {}
    for folder in folders:
        other = first.setdefault(folder.name[:2], folder)
        if other is not folder:
            what = f"`{folder.name}` and `{other.name}` have the same number"
            yield ContentError(what, "give each chapter a number of its own", file=folder)


def _text_problems(folder: Path, ids: tuple[str, ...]) -> Iterator[ContentError]:
    for file in (folder / layout.LESSON_TEXT, *(layout.exercise_text(folder, name) for name in ids)):
        try:
            read_text(file)
        except ContentError as error:
            yield error


def _strays(folder: Path, ids: tuple[str, ...]) -> Iterator[ContentError]:
    """Texts, starters and mysteries that no exercise uses, mostly misspelt ones."""
    texts = {file: file.stem for file in folder.glob("*.md") if file.name != layout.LESSON_TEXT}
    starters = {path: path.name for path in folder.glob("starter/*")}
    plays = {path: path.stem for path in folder.glob("play/*") if path.name[0] not in "._"}
    for path, name in {**texts, **starters, **plays}.items():
        if name not in ids:
            what = f"no exercise of this chapter is called `{name}`{did_you_mean(name, ids)}"
            yield ContentError(what, f"allowed: {', '.join(ids)}", file=path)


def _grader_and_solution(folder: Path, reading: LessonReading) -> Iterator[ContentError]:
    assert reading.data is not None and reading.document is not None
    exercises = reading.data["exercises"]
    grader, solution = layout.grader_file(folder), layout.solution_folder(folder)
    if not all(_is_quiz(folder, exercise) for exercise in exercises) and not grader.is_file():
        yield ContentError("the grader of this chapter is missing", f"create {grader.name}", file=grader)
    for index, exercise in enumerate(exercises):
        yield from _computed_by_nobody(folder, reading.document, exercise, index)
        for number, file in enumerate(exercise["files"]):
            if not (solution / file).is_file():
                what = f"`{file}` is not in the reference solution ({solution.name})"
                place = ("exercises", index, "files", number)
                yield reading.document.error(what, "add it there, or correct the path", place=place)


def _is_quiz(folder: Path, exercise: dict[str, Any]) -> bool:
    """Whether its questions alone are judged, for which no grader is needed."""
    return bool(exercise["questions"]) and layout.play_file(folder, exercise["id"]) is None


def _computed_by_nobody(
    folder: Path, document: Document, exercise: dict[str, Any], index: int
) -> Iterator[ContentError]:
    if layout.play_file(folder, exercise["id"]) is None:
        for number, item in enumerate(exercise["questions"]):
            if item["computed"]:
                what = f"`{exercise['id']}` has no mystery that could compute the answer"
                place = ("exercises", index, "questions", number, "computed")
                yield document.error(what, f"create play/{exercise['id']}.py", place=place)
