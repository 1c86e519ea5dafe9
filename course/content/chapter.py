"""What a course is made of: chapters and their exercises. Read-only data.

Known mistakes and other solutions, which only graders' tests need, are read on demand. Valid lessons are
cached: reading YAML and checking it with pydantic takes about 0.15 s, most of it for imports, and would slow
down every `hint`. A cached lesson is JSON with a hash of the file and of the modules that checked it. If
either has changed, or the cached file is damaged, the lesson is read again.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from course.content import layout
from course.content.entries import Alternative, Mistake, Question, question_of
from course.content.layout import LESSON, WORKSPACE
from course.errors import ContentError
from course.files import write_atomic


@dataclass(frozen=True)
class ChapterRef:
    """What an exercise knows about its chapter. `slug` is the chapter's folder: `12-a-node-from-scratch`."""

    number: int
    title: str
    slug: str


@dataclass(frozen=True)
class Lesson:
    """What a learner reads before an exercise. text: Markdown. id: its name in the learner's progress."""

    chapter: ChapterRef
    text: str
    id: str


@dataclass(frozen=True)
class Exercise:
    """One exercise of a chapter.

    files: the learner's files, relative to the course home. packages: the ROS packages in
    `workspace`/src that are built for it.
    grader_packages: packages whose reference build the grader itself needs. requires: ids of the
    exercises that it builds on. text, hints, after: Markdown. time_limit: seconds.
    starter, grader, solution: paths that may not exist (a quiz has no solution). questions: asked
    by `check`. play: the module of the exercise's mystery, if it has one. looks_at: more files,
    folders, and patterns in the course home that the grader looks at. bonus: not needed to complete
    the course. local_only: about the learner's own machine, so not part of a submission. step: the
    heading of its part of the lesson; empty if it shares the part of the exercise before it.
    """

    id: str
    title: str
    summary: str
    chapter: ChapterRef
    step: str
    text: str
    hints: tuple[str, ...]
    after: str | None
    files: tuple[str, ...]
    packages: tuple[str, ...]
    grader_packages: tuple[str, ...]
    requires: tuple[str, ...]
    time_limit: float
    grader: Path
    starter: Path
    solution: Path
    folder: Path
    questions: tuple[Question, ...] = ()
    play: Path | None = None
    looks_at: tuple[str, ...] = ()
    bonus: bool = False
    local_only: bool = False
    workspace: str = WORKSPACE

    def mistakes(self) -> tuple[Mistake, ...]:
        """The mistakes listed for this exercise; read from the chapter's mistakes.yaml now."""
        from course.content.mistakes import load_mistakes  # imports YAML, which is slow

        return tuple(mistake for mistake in load_mistakes(self.folder) if mistake.exercise == self.id)

    def alternatives(self) -> tuple[Alternative, ...]:
        """Other right solutions of this exercise; read from the chapter's solutions folder now."""
        from course.content.mistakes import load_alternatives  # as above

        return tuple(other for other in load_alternatives(self.solution) if self.id in other.exercises)


@dataclass(frozen=True)
class Chapter:
    """One chapter. `slug` is the name of `folder`; `text` is lesson.md with the links added at its end."""

    number: int
    slug: str
    title: str
    summary: str
    text: str
    exercises: tuple[Exercise, ...]
    folder: Path


LessonData = dict[str, Any]
_RULES = ("document.py", "schema.py", "schema_types.py", "schema_errors.py", "lesson.py")


@dataclass(frozen=True)
class LessonCache:
    """A cache of lessons in `folder`, with one small file for each chapter."""

    folder: Path

    def get(self, chapter: Path, read: Callable[[], LessonData]) -> LessonData:
        """The chapter's lesson: from the cache if still valid, else what `read` returns or raises."""
        try:
            proof = _proof(chapter)  # before `read`: the hash must not cover changes that `read` missed
        except OSError:
            return read()
        kept = self._kept(chapter, proof)
        if kept is not None:
            return kept
        lesson = read()
        self._keep(chapter, proof, lesson)
        return lesson

    def _kept(self, chapter: Path, proof: str) -> LessonData | None:
        try:
            kept = json.loads(self._file(chapter).read_text(encoding="utf-8"))
            lesson = kept["lesson"] if kept["proof"] == proof else None
        except (OSError, ValueError, KeyError, TypeError):
            return None
        return lesson if isinstance(lesson, dict) else None

    def _keep(self, chapter: Path, proof: str, lesson: LessonData) -> None:
        """Ignore a full or read-only disk: the next command only takes longer."""
        with contextlib.suppress(OSError):
            write_atomic(self._file(chapter), json.dumps({"proof": proof, "lesson": lesson}))

    def _file(self, chapter: Path) -> Path:
        place = hashlib.sha256(os.fsencode(chapter.resolve())).hexdigest()[:16]
        return self.folder / f"{chapter.name}-{place}.json"


def _proof(chapter: Path) -> str:
    """A hash of everything that the content of this lesson depends on."""
    here = Path(__file__).parent
    parts = [chapter / LESSON, *(here / name for name in _RULES)]
    return hashlib.sha256(b"\0".join(part.read_bytes() for part in parts)).hexdigest()


def load_chapter(folder: Path, cache: LessonCache | None = None) -> Chapter:
    """Raises ContentError for the first thing that is wrong; `audit` finds them all."""
    data = cache.get(folder, lambda: _lesson(folder)) if cache else _lesson(folder)
    ref = ChapterRef(data["chapter"], data["title"], folder.name)
    return Chapter(
        number=ref.number,
        slug=ref.slug,
        title=ref.title,
        summary=data["summary"],
        text=_lesson_text(folder, data["links"]),
        exercises=tuple(_exercise(folder, ref, item) for item in data["exercises"]),
        folder=folder,
    )


def lesson_of(chapter: Chapter, exercise: Exercise | None = None) -> Lesson:
    """The whole lesson, or the step of `exercise`. Raises ContentError if a step's heading is missing."""
    ref = ChapterRef(chapter.number, chapter.title, chapter.slug)
    until = chapter.exercises[: chapter.exercises.index(exercise) + 1] if exercise else ()
    steps = [one.step for one in chapter.exercises if one.step]
    current = len([one for one in until if one.step]) - 1
    if current < 0:
        return Lesson(ref, chapter.text, chapter.slug)
    places = [_place(chapter, step) for step in steps]
    text = chapter.text[places[current] if current else 0 : (*places, None)[current + 1]]
    return Lesson(ref, text, f"{chapter.slug}#{steps[current]}" if current else chapter.slug)


def _place(chapter: Chapter, heading: str) -> int:
    found = re.search(rf"^## {re.escape(heading)}$", chapter.text, re.MULTILINE)
    if found is None:
        file = chapter.folder / layout.LESSON_TEXT
        raise ContentError(f"the heading `## {heading}` is missing", "add it, or correct `step`", file=file)
    return found.start()


def read_text(file: Path) -> str:
    """The Markdown of a lesson or an exercise."""
    try:
        text = file.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise ContentError(f"{file.name} is missing", f"write the text into {file.name}", file=file) from None
    except UnicodeDecodeError:
        raise ContentError("this is not UTF-8 text", "save it as UTF-8", file=file) from None
    except OSError as error:
        raise ContentError(f"cannot be read: {error.strerror}", file=file) from error
    if not text.strip():
        raise ContentError(f"{file.name} is empty", "write the text into it", file=file, line=1)
    return text


def _lesson_text(folder: Path, links: dict[str, str]) -> str:
    text = read_text(folder / layout.LESSON_TEXT)
    # In a code block, a terminal shows each address on one line, where it can be clicked or copied.
    pages = "\n\n".join(f"{title}\n{url}" for title, url in links.items())
    return f"{text.rstrip()}\n\n## Read more\n\n```text\n{pages}\n```\n" if pages else text


def _lesson(folder: Path) -> dict[str, Any]:
    from course.content.lesson import read_lesson  # imports YAML and pydantic, which is slow

    reading = read_lesson(folder)
    if reading.value is None:
        raise reading.problems[0]
    return reading.value


def _exercise(folder: Path, ref: ChapterRef, data: dict[str, Any]) -> Exercise:
    made: dict[str, Any] = {
        "chapter": ref,
        "text": read_text(layout.exercise_text(folder, data["id"])),
        "files": _files(data),
        "grader": layout.grader_file(folder),
        "starter": layout.starter_folder(folder, data["id"]),
        "solution": layout.solution_folder(folder),
        "folder": folder,
        "questions": tuple(_question(folder, item) for item in data["questions"]),
        "play": layout.play_file(folder, data["id"]),
    }
    plain: dict[str, Any] = {
        key: tuple(value) if isinstance(value, list) else value for key, value in data.items()
    }
    return Exercise(**(plain | made))


def _question(folder: Path, data: dict[str, Any]) -> Question:
    program = folder / layout.PROGRAMS / data["program"] if data["program"] else None
    return question_of(data, program, read_text(program) if program else "")


def _files(data: dict[str, Any]) -> tuple[str, ...]:
    """The learner's files, including the answers file if there are questions."""
    answers = [layout.answers_file(data["id"])] if data["questions"] else []
    return tuple(dict.fromkeys((*data["files"], *answers)))
