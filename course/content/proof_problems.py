"""Whether mistakes and alternatives fit the exercises and the reference solution they change."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from course.content import layout
from course.content.document import Document, Place
from course.content.edited import Edited
from course.content.model import Edit, Mistake
from course.content.names import did_you_mean
from course.content.proofs import read_alternatives, read_mistakes
from course.errors import ContentError

Ids = tuple[str, ...]

# The right answers to questions, and the acts in a mystery, are computed where no file of them is stored;
# and a workspace that is built in the trial home is in none. (What is installed there: see `_is_made`.)
_MADE = re.compile(r"answers/|\.ros2course/acts/|[^/]+_workspace/(build|install|log|src$)")


# Where a line of built.txt installs a CMake project to.
_INSTALLED = re.compile(r"-DCMAKE_INSTALL_PREFIX=~/(\S+)")


def proof_problems(chapter: Path, ids: Ids) -> Iterator[ContentError]:
    solution = layout.solution_folder(chapter)
    yield from _mistakes_problems(chapter, ids, solution)
    for reading in read_alternatives(solution):
        yield from reading.problems
        if reading.alternative and reading.document:
            yield from _unknown_exercises(reading.document, reading.alternative.exercises, ids)
            yield from _missing_deletes(reading.document, reading.alternative.deletes, solution)


def _mistakes_problems(chapter: Path, ids: Ids, solution: Path) -> Iterator[ContentError]:
    reading = read_mistakes(chapter)
    yield from reading.problems
    for index, mistake in enumerate(reading.mistakes):
        assert reading.document is not None
        if mistake.exercise not in ids:
            yield _no_exercise(reading.document, mistake.exercise, ids, ("mistakes", index, "exercise"))
        yield from _edit_problems(reading.document, mistake, ("mistakes", index, "edits"), solution)


def _unknown_exercises(document: Document, wanted: Ids, ids: Ids) -> Iterator[ContentError]:
    for index, name in enumerate(wanted):
        if name not in ids:
            yield _no_exercise(document, name, ids, ("exercises", index))


def _missing_deletes(document: Document, files: tuple[str, ...], solution: Path) -> Iterator[ContentError]:
    for index, file in enumerate(files):
        if not (solution / file).is_file():
            yield _no_file(document, file, solution, ("deletes", index))


def _edit_problems(
    document: Document, mistake: Mistake, place: Place, solution: Path
) -> Iterator[ContentError]:
    """Each edit is judged by what those before it made of the solution."""
    edited = Edited(solution)
    for index, edit in enumerate(mistake.edits):
        yield from _edit_problem(document, edit, (*place, index), edited)
        edited.apply(edit)


def _edit_problem(document: Document, edit: Edit, place: Place, edited: Edited) -> Iterator[ContentError]:
    if edit.answers is not None:
        yield from _answers_problem(document, edit, place)
        return
    if edit.content is not None or _is_made(edit.file, edited.solution):
        return
    if (edit.delete or edit.rename is not None) and (edited.solution / edit.file).is_dir():
        return
    text = edited.text(edit.file)
    if text is None and (edited.solution / edit.file).is_file():
        what = f"an edit before this one took `{edit.file}` away"
        yield document.error(what, "change their order, or name the file as it is called then", place=place)
    elif text is None:
        yield _no_file(document, edit.file, edited.solution, (*place, "file"))
    elif edit.replace is not None and edit.replace not in text:
        what = f"this text does not occur in {edit.file}"
        advice = "copy the text from the reference solution, with its spaces and line ends"
        if text != Edited(edited.solution).text(edit.file):
            advice += "; an edit before this one has changed the file"
        yield document.error(what, advice, place=(*place, "replace"))


def _is_made(file: str, solution: Path) -> bool:
    """Whether the file is in no solution: it is made when a trial home is laid."""
    built = solution / layout.BUILT
    text = built.read_text(encoding="utf-8") if built.is_file() else ""
    prefixes = _INSTALLED.findall(text)
    return bool(_MADE.match(file)) or any(f"{file}/".startswith(f"{prefix}/") for prefix in prefixes)


def _answers_problem(document: Document, edit: Edit, place: Place) -> Iterator[ContentError]:
    """The question ids are proved by the exercise's own tests: a chapter's questions are not known here."""
    folder, _, name = edit.file.rpartition("/")
    if folder != "answers" or not name.endswith(".yaml"):
        what = f"`answers` goes with an answers file, not with `{edit.file}`"
        yield document.error(what, "allowed: `answers/<exercise>.yaml`", place=(*place, "file"))


def _no_exercise(document: Document, name: str, ids: Ids, place: Place) -> ContentError:
    what = f"no exercise of this chapter is called `{name}`{did_you_mean(name, ids)}"
    return document.error(what, f"allowed: {', '.join(ids)}", place=place)


def _no_file(document: Document, file: str, solution: Path, place: Place) -> ContentError:
    known = [path.relative_to(solution).as_posix() for path in solution.rglob("*") if path.is_file()]
    what = f"`{file}` is not in the reference solution{did_you_mean(file, known)}"
    return document.error(what, "allowed: a file of the reference solution", place=place)
