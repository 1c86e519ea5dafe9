"""Files of the course that nothing uses, and links in texts that lead to nothing.

Links to the internet are not followed.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from itertools import takewhile
from pathlib import Path, PurePosixPath
from urllib.parse import unquote, urlsplit

from course.authoring.write import template_text
from course.content import Exercise, answers_file, layout
from course.content.layout import ADDED_TO
from course.home import starter_files
from course.spelling import did_you_mean
from course.validate import Finding
from course.validate.static.markdown_parts import Link, contents
from course.validate.static.subject import Prose, Subject, files_in, text_of

_README = "README.md"
_STEP = "delete it, or name it where it is used"
# "The package `lamp` is there", "`lamp/node.py` is already there"
_THERE = re.compile(r"`(?:[^`]*/)?([^`/]+)/?` (?:is|are) (?:already )?there\b")
_SENTENCE = 40  # letters; shorter lines may be the same by chance
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
        yield from _promised(subject, exercise)
    for chapter in subject.chapters:
        yield from _left_to_write(chapter)
        if subject.is_read(chapter):
            yield from _solution_files(subject, chapter)


def _beside_chapters(subject: Subject) -> Iterator[Path]:
    for path in sorted((subject.course.root / "chapters").iterdir()):
        if not path.is_dir() and path.name not in (_README, ".DS_Store"):
            yield path


def _of_chapters(subject: Subject) -> Iterator[Path]:
    """Files in chapters, except texts, starters, and mysteries, which `course.content.problems` checks."""
    for chapter in filter(subject.is_read, subject.chapters):
        questions = (one for exercise in subject.exercises_of(chapter) for one in exercise.questions)
        programs = {question.program for question in questions}
        for file in files_in(chapter):
            first = file.relative_to(chapter).parts[0]
            known = first in ("starter", "play") or file in programs or file.name in _OF_CHAPTER
            if not known and file.suffix != ".md":
                yield file


def _solutions(subject: Subject) -> Iterator[Finding]:
    folder = subject.course.root / "solutions"
    known = [chapter.name for chapter in subject.chapters]
    for path in sorted(folder.iterdir()) if folder.is_dir() else ():
        if path.name not in (*known, _README) and path.name[0] not in "._":
            what = f"no chapter is called `{path.name}`{did_you_mean(path.name, known)}"
            yield Finding(path, None, what, "give the folder of solutions the name of its chapter's folder")
    for chapter in subject.chapters:
        others = layout.solution_folder(chapter) / "alternatives"
        for path in sorted(others.iterdir()) if others.is_dir() else ():
            if not path.is_dir():
                what = f"`{path.name}` belongs to no alternative"
                yield Finding(path, None, what, "an alternative is a folder with alternative.yaml in it")


def _graders(subject: Subject) -> Iterator[Finding]:
    """Files in the graders' folder that are neither a chapter's module nor used by another one."""
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
            yield Finding(file, None, what, "name it after its chapter: `ch18_name.py` for `18-name`")


def _starter(subject: Subject, exercise: Exercise) -> Iterator[Finding]:
    told = "\n".join([exercise.text, text_of(exercise.folder / layout.LESSON_TEXT) or "", *exercise.hints])
    for file in starter_files(exercise):
        if not _is_used(file, subject.exercises.values()) and PurePosixPath(file).name not in told:
            what = f"no exercise uses `{file}` of this starter"
            step = "name it in `files` or `looks_at` of lesson.yaml, mention it in the text, or delete it"
            yield Finding(exercise.starter / file, None, what, step, exercise.id)


def _promised(subject: Subject, exercise: Exercise) -> Iterator[Finding]:
    """Files that exist according to the text, but neither the starter nor an earlier exercise provides."""
    before = takewhile(lambda one: one is not exercise, subject.exercises.values())
    brought = (file for one in before for file in (*one.files, *starter_files(one)))
    there = {part for file in (*starter_files(exercise), *brought) for part in PurePosixPath(file).parts}
    own = {*exercise.packages, *(PurePosixPath(file).name for file in exercise.files)}
    text = layout.exercise_text(exercise.folder, exercise.id)
    for number, line in enumerate((text_of(text) or "").splitlines(), 1):
        for name in (own - there).intersection(_THERE.findall(line)):
            what = f"the text says that `{name}` is there, but the starter does not contain it"
            step = f"add it to {exercise.starter.relative_to(exercise.folder)}, or correct the text"
            yield Finding(text, number, what, step, exercise.id)


def _left_to_write(chapter: Path) -> Iterator[Finding]:
    for name in (layout.LESSON, layout.LESSON_TEXT):
        template = _template(name)
        for number, line in enumerate((text_of(chapter / name) or "").splitlines(), 1):
            if line in template:
                what = f"this line is still the one that `new chapter` wrote: {line.strip()}"
                yield Finding(chapter / name, number, what, "write your own text here, or delete the line")


@cache
def _template(name: str) -> frozenset[str]:
    lines = (line for line in template_text(f"chapter/{name}").splitlines() if len(line) > _SENTENCE)
    return frozenset(line for line in lines if line[0] not in "#|" and "$" not in line)


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


def link_findings(texts: Sequence[Prose]) -> Iterator[Finding]:
    for text in texts:
        for link in contents(text.text).links:
            problem = _problem(text, link)
            if problem:
                yield Finding(text.file, text.at(link.line), *problem, text.exercise)


def linked_files(texts: Sequence[Prose]) -> frozenset[Path]:
    """The files to which links lead."""
    found = (_link_place(text, link) for text in texts for link in contents(text.text).links)
    return frozenset(file for file, _anchor in filter(None, found))


def _link_place(text: Prose, link: Link) -> tuple[Path, str] | None:
    """File and anchor; None for a web address or an invalid one."""
    try:
        parts = urlsplit(link.target)
    except ValueError:
        return None
    if parts.scheme or parts.netloc:
        return None
    file = (text.file.parent / unquote(parts.path)).resolve() if parts.path else text.file
    return file, unquote(parts.fragment)


def _problem(text: Prose, link: Link) -> tuple[str, str] | None:
    place = _link_place(text, link)
    if place is None:
        return None
    file, anchor = place
    if not file.exists():
        near = [path.name for path in text.file.parent.iterdir()]
        what = f"the link to `{link.target}` leads nowhere{did_you_mean(link.target, near)}"
        return what, "name a file that exists, seen from the folder of this text"
    anchors = contents(text_of(file) or "").anchors if file.suffix == ".md" else frozenset()
    if anchor and anchor not in anchors:
        what = f"{file.name} has no heading `#{anchor}`{did_you_mean(anchor, anchors)}"
        return what, f"its headings: {', '.join(sorted(anchors)) or 'none'}"
    return None
