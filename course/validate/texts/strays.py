"""Files of the course that nothing uses, mostly misnamed or left over."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path, PurePosixPath

from course.content import Exercise, answers_file, layout
from course.content.additions import ADDED_TO
from course.content.names import did_you_mean
from course.home import starter_files
from course.validate.model import Finding
from course.validate.texts.links import linked_files
from course.validate.texts.prose import Prose
from course.validate.texts.subject import Subject, files_in, text_of

_README = "README.md"
_STEP = "delete it, or name it where it is used"
_OF_CHAPTER = {layout.LESSON, layout.LESSON_TEXT, layout.MISTAKES, _README}


def stray_findings(subject: Subject, texts: Sequence[Prose]) -> Iterator[Finding]:
    linked = linked_files(texts)
    for place in (*_beside_chapters(subject), *_of_chapters(subject)):
        if place.resolve() not in linked:
            yield Finding(place, None, f"nothing uses `{place.name}`", _STEP)
    yield from _solutions(subject)
    yield from _graders(subject)
    for exercise in subject.exercises.values():
        yield from _starter(subject, exercise)
    for chapter in subject.chapters:
        if subject.lessons[chapter].data is not None:
            yield from _solution_files(subject, chapter)


def _beside_chapters(subject: Subject) -> Iterator[Path]:
    for path in sorted((subject.course.root / "chapters").iterdir()):
        if not path.is_dir() and path.name not in (_README, ".DS_Store"):
            yield path


def _of_chapters(subject: Subject) -> Iterator[Path]:
    """Not the texts, starters and mysteries, which `course.content.problems` looks at."""
    for chapter in subject.chapters:
        for file in files_in(chapter):
            first = file.relative_to(chapter).parts[0]
            if first not in ("starter", "play") and file.suffix != ".md" and file.name not in _OF_CHAPTER:
                yield file


def _solutions(subject: Subject) -> Iterator[Finding]:
    folder = subject.course.root / "solutions"
    known = [chapter.name for chapter in subject.chapters]
    for path in sorted(folder.iterdir()) if folder.is_dir() else ():
        if path.name not in (*known, _README) and path.name[0] not in "._":
            what = f"no chapter is called `{path.name}`{did_you_mean(path.name, known)}"
            yield Finding(path, None, what, "give the solutions the name of their chapter's folder")
    for chapter in subject.chapters:
        others = layout.solution_folder(chapter) / "alternatives"
        for path in sorted(others.iterdir()) if others.is_dir() else ():
            if not path.is_dir():
                what = f"`{path.name}` belongs to no alternative"
                yield Finding(path, None, what, "an alternative is a folder with alternative.yaml in it")


def _graders(subject: Subject) -> Iterator[Finding]:
    """Besides the chapters' own modules, what those name: modules and programs that they share."""
    folder = subject.course.root / "graders"
    known = {layout.grader_file(chapter) for chapter in subject.chapters}
    files = tuple(files_in(folder)) if folder.is_dir() else ()
    texts = {file: text_of(file) or "" for file in files if file.suffix == ".py"}
    for file in files:
        if file in known or file.name in ("conftest.py", "__init__.py", _README):
            continue
        others = (text for other, text in texts.items() if other != file)
        if not any(re.search(rf"\b{re.escape(file.stem)}\b", text) for text in others):
            what = f"no chapter has a grader called `{file.name}`, and no grader uses it"
            what += did_you_mean(file.name, [grader.name for grader in known])
            yield Finding(file, None, what, "call it as its chapter: `ch18_name.py` for `18-name`")


def _starter(subject: Subject, exercise: Exercise) -> Iterator[Finding]:
    told = "\n".join([exercise.text, text_of(exercise.folder / layout.LESSON_TEXT) or "", *exercise.hints])
    for file in starter_files(exercise):
        if not _is_used(file, subject.exercises.values()) and PurePosixPath(file).name not in told:
            what = f"no exercise uses `{file}` of this starter"
            step = "name it in `files` or `looks_at` of lesson.yaml, tell of it in the text, or delete it"
            yield Finding(exercise.starter / file, None, what, step, exercise.id)


def _solution_files(subject: Subject, chapter: Path) -> Iterator[Finding]:
    solution = layout.solution_folder(chapter)
    for path in files_in(solution) if solution.is_dir() else ():
        file = path.relative_to(solution).as_posix()
        is_ours = file.startswith("alternatives/") or file in (layout.BUILT, _README)
        if not is_ours and not _is_used(file, subject.exercises.values()):
            what = f"no exercise uses `{file}` of this solution"
            yield Finding(path, None, what, "name it in `files` or `looks_at` of lesson.yaml, or delete it")


def _is_used(file: str, exercises: Iterable[Exercise]) -> bool:
    return file in ADDED_TO or any(_uses(exercise, PurePosixPath(file)) for exercise in exercises)


def _uses(exercise: Exercise, file: PurePosixPath) -> bool:
    places = {file.as_posix(), *(parent.as_posix() for parent in file.parents)}
    if places & {*exercise.files, *exercise.looks_at, answers_file(exercise.id)}:
        return True
    if set(file.parts[:-1]) & {*exercise.packages, *exercise.grader_packages}:
        return True
    return any(PurePosixPath(place).match(wanted) for place in places for wanted in exercise.looks_at)
