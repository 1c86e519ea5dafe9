"""Finds everything that is wrong with a course folder, for its author to fix before learners use it.

A learner's command stops at the first error in the chapter that it needs. This checks all files, including
problems that only show when several files are compared.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from course.content import layout
from course.content.chapter import read_text
from course.content.document import Document, Place
from course.content.entries import Edit, Mistake
from course.content.layout import ADDED_TO
from course.content.lesson import read_lesson
from course.content.mistakes import read_alternatives, read_mistakes
from course.content.schema_errors import Reading
from course.errors import ContentError
from course.spelling import did_you_mean

Data = dict[str, Any]
Graph = Mapping[str, Sequence[str]]
Ids = tuple[str, ...]


def audit(root: Path) -> tuple[ContentError, ...]:
    """All problems of the course in `root`, sorted by file and line; empty if there are none."""
    folders = layout.chapter_folders(root)
    readings = {folder: read_lesson(folder) for folder in folders}
    found = [problem for reading in readings.values() for problem in reading.problems]
    found += _same_number(folders)
    found += _requires_problems(readings.values())
    for folder, reading in readings.items():
        if reading.value is not None and reading.document is not None:
            data, document = reading.value, reading.document
            ids = tuple(exercise["id"] for exercise in data["exercises"])
            found += [*_text_problems(folder, document, data), *_strays(folder, ids)]
            found += [*_grader_and_solution(folder, document, data), *_proof_problems(folder, ids)]
    return tuple(sorted(found, key=lambda problem: (str(problem.file), problem.line or 0)))


def _same_number(folders: tuple[Path, ...]) -> Iterator[ContentError]:
    first: dict[str, Path] = {}
    for folder in folders:
        other = first.setdefault(folder.name[:2], folder)
        if other is not folder:
            what = f"`{folder.name}` and `{other.name}` have the same number"
            yield ContentError(what, "give each chapter its own number", file=folder)


def _text_problems(folder: Path, document: Document, data: Data) -> Iterator[ContentError]:
    files = [folder / layout.LESSON_TEXT]
    for exercise in data["exercises"]:
        files.append(layout.exercise_text(folder, exercise["id"]))
        names = filter(None, (question["program"] for question in exercise["questions"]))
        files += [folder / layout.PROGRAMS / name for name in names]
    for file in files:
        try:
            text = read_text(file)
        except ContentError as error:
            yield error
            continue
        if file.name == layout.LESSON_TEXT:
            yield from _step_problems(document, data, text)


def _step_problems(document: Document, data: Data, text: str) -> Iterator[ContentError]:
    lines = text.splitlines()
    for index, exercise in enumerate(data["exercises"]):
        heading = f"## {exercise['step']}"
        if exercise["step"] and heading not in lines:
            what = f"lesson.md has no heading `{heading}` after that of the previous step"
            yield document.error(what, "add it, or correct `step`", place=("exercises", index, "step"))
        elif exercise["step"]:
            lines = lines[lines.index(heading) + 1 :]


def _strays(folder: Path, ids: tuple[str, ...]) -> Iterator[ContentError]:
    """Texts, starters, and mysteries that no exercise uses, most of them because of a misspelled name."""
    texts = {file: file.stem for file in folder.glob("*.md") if file.name != layout.LESSON_TEXT}
    starters = {path: path.name for path in folder.glob("starter/*")}
    plays = {path: path.stem for path in folder.glob("play/*") if path.name[0] not in "._"}
    for path, name in {**texts, **starters, **plays}.items():
        if name not in ids:
            what = f"no exercise of this chapter is called `{name}`{did_you_mean(name, ids)}"
            yield ContentError(what, f"allowed: {', '.join(ids)}", file=path)


def _grader_and_solution(folder: Path, document: Document, data: Data) -> Iterator[ContentError]:
    exercises = data["exercises"]
    grader, solution = layout.grader_file(folder), layout.solution_folder(folder)
    if not all(_is_quiz(folder, exercise) for exercise in exercises) and not grader.is_file():
        yield ContentError("the grader of this chapter is missing", f"create {grader.name}", file=grader)
    for index, exercise in enumerate(exercises):
        yield from _computed_by_nobody(folder, document, exercise, index)
        for number, file in enumerate(exercise["files"]):
            if not (solution / file).is_file():
                what = f"`{file}` is not in the reference solution ({solution.name})"
                place = ("exercises", index, "files", number)
                yield document.error(what, "add it there, or correct the path", place=place)


def _is_quiz(folder: Path, exercise: Data) -> bool:
    """Whether the exercise consists only of questions, and so needs no grader."""
    return bool(exercise["questions"]) and layout.play_file(folder, exercise["id"]) is None


def _computed_by_nobody(
    folder: Path, document: Document, exercise: Data, index: int
) -> Iterator[ContentError]:
    if layout.play_file(folder, exercise["id"]) is None:
        for number, item in enumerate(exercise["questions"]):
            if item["computed"]:
                what = f"`{exercise['id']}` has no mystery that could compute the answer"
                place = ("exercises", index, "questions", number, "computed")
                yield document.error(what, f"create play/{exercise['id']}.py", place=place)


def _requires_problems(readings: Iterable[Reading[Data]]) -> Iterator[ContentError]:
    usable = [(one.document, one.value["exercises"]) for one in readings if one.value and one.document]
    graph = {exercise["id"]: exercise["requires"] for _, exercises in usable for exercise in exercises}
    for document, exercises in usable:
        for index, exercise in enumerate(exercises):
            for number, required in enumerate(exercise["requires"]):
                problem = _requires_problem(graph, exercise["id"], required)
                if problem:
                    yield document.error(*problem, place=("exercises", index, "requires", number))


def _requires_problem(graph: Graph, exercise: str, required: str) -> tuple[str, str] | None:
    if required not in graph:
        what = f"there is no exercise `{required}`{did_you_mean(required, graph)}"
        return what, "allowed: the id of an exercise of this course"
    way = way_between(graph, required, exercise)
    if way and exercise == min(way):  # report a cycle once, not for each of its members
        what = f"`{exercise}` requires itself: {' -> '.join((exercise, *way))}"
        return what, "remove one of them from `requires`"
    return None


def way_between(graph: Graph, start: str, goal: str) -> tuple[str, ...]:
    """The names on a shortest path from `start` to `goal` in the graph; empty if there is no path."""
    ways: list[tuple[str, ...]] = [(start,)]
    seen = {start}
    for way in ways:  # breadth first: `ways` grows during the loop
        if way[-1] == goal:
            return way
        new = [name for name in graph.get(way[-1], ()) if name not in seen]
        seen.update(new)
        ways += [(*way, name) for name in new]
    return ()


# Files that a trial home makes, so that no solution contains them: right answers to questions, the acts of a
# mystery, and a workspace's build. (`_is_made` adds what CMake projects install.)
_MADE = re.compile(r"answers/|\.ros2course/acts/|[^/]+_workspace/(build|install|log|src$)")


# Where a line of built.txt installs a CMake project.
_INSTALLED = re.compile(r"-DCMAKE_INSTALL_PREFIX=~/(\S+)")


def _proof_problems(chapter: Path, ids: Ids) -> Iterator[ContentError]:
    solution = layout.solution_folder(chapter)
    yield from _mistakes_problems(chapter, ids, solution)
    for reading in read_alternatives(solution):
        yield from reading.problems
        if reading.value and reading.document:
            yield from _unknown_exercises(reading.document, reading.value.exercises, ids)
            yield from _missing_deletes(reading.document, reading.value.deletes, solution)


def _mistakes_problems(chapter: Path, ids: Ids, solution: Path) -> Iterator[ContentError]:
    reading = read_mistakes(chapter)
    yield from reading.problems
    for index, mistake in enumerate(reading.value or ()):
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
    """Apply the edits in order: each one sees what the previous ones changed."""
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
        what = f"an earlier edit removed or renamed `{edit.file}`"
        yield document.error(what, "change their order, or use the file's name at that point", place=place)
    elif text is None:
        yield _no_file(document, edit.file, edited.solution, (*place, "file"))
    elif edit.replace is not None and edit.replace not in text:
        what = f"this text does not occur in {edit.file}"
        advice = "copy the text from the reference solution, with its spaces and line ends"
        if text != Edited(edited.solution).text(edit.file):
            advice += "; an earlier edit has changed the file"
        yield document.error(what, advice, place=(*place, "replace"))


def _is_made(file: str, solution: Path) -> bool:
    """Whether the trial home makes this file, so that no solution contains it."""
    built = solution / layout.BUILT
    text = built.read_text(encoding="utf-8") if built.is_file() else ""
    prefixes = _INSTALLED.findall(text)
    return bool(_MADE.match(file)) or any(f"{file}/".startswith(f"{prefix}/") for prefix in prefixes)


def _answers_problem(document: Document, edit: Edit, place: Place) -> Iterator[ContentError]:
    """Only the file's name is checked here; `validate` checks the question ids."""
    folder, _, name = edit.file.rpartition("/")
    if folder != "answers" or not name.endswith(".yaml"):
        what = f"`answers` is for an answers file, not for `{edit.file}`"
        yield document.error(what, "allowed: `answers/<exercise>.yaml`", place=(*place, "file"))


def _no_exercise(document: Document, name: str, ids: Ids, place: Place) -> ContentError:
    what = f"no exercise of this chapter is called `{name}`{did_you_mean(name, ids)}"
    return document.error(what, f"allowed: {', '.join(ids)}", place=place)


def _no_file(document: Document, file: str, solution: Path, place: Place) -> ContentError:
    known = [path.relative_to(solution).as_posix() for path in solution.rglob("*") if path.is_file()]
    what = f"`{file}` is not in the reference solution{did_you_mean(file, known)}"
    return document.error(what, "allowed: a file of the reference solution", place=place)


class Edited:
    """The files of `solution` and of the solutions before it; `apply` changes what `text` returns."""

    def __init__(self, solution: Path) -> None:
        self.solution = solution
        self._changed: dict[str, str | None] = {}

    def text(self, file: str) -> str | None:
        """The file's text; None if there is no such file, or if an edit removed it."""
        if file in self._changed:
            return self._changed[file]
        own = _read(self.solution / file)
        if own is not None and file not in ADDED_TO:
            return own
        # A trial also contains files from earlier exercises. We search all earlier chapters for them.
        others = sorted(self.solution.parent.glob("*/"), reverse=True)
        earlier = [_read(other / file) for other in others if other.name < self.solution.name]
        found = [text for text in (own, *earlier) if text is not None]
        if file in ADDED_TO:
            return "\n".join(found) if found else None
        return found[0] if found else None

    def apply(self, edit: Edit) -> None:
        """An edit that does not fit changes nothing."""
        text = self.text(edit.file)
        if edit.content is not None:
            self._changed[edit.file] = edit.content
        elif text is not None and (edit.delete or edit.rename is not None):
            self._changed[edit.file] = None
            if edit.rename is not None:
                self._changed[edit.rename] = text
        elif text is not None and edit.replace is not None:
            self._changed[edit.file] = text.replace(edit.replace, edit.with_ or "")


def _read(file: Path) -> str | None:
    try:
        return file.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return None
