"""Makes a Chapter of what its folder holds."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from course.content import layout
from course.content.cache import LessonCache
from course.content.model import Chapter, ChapterRef, Exercise, Lesson
from course.content.question import question_of
from course.errors import ContentError


def load_chapter(folder: Path, cache: LessonCache | None = None) -> Chapter:
    """Raises ContentError for the first thing that is wrong; `audit` finds them all."""
    data = cache.get(folder, lambda: _lesson(folder)) if cache else _lesson(folder)
    ref = ChapterRef(data["chapter"], data["title"], folder.name)
    return Chapter(
        number=ref.number,
        slug=ref.slug,
        title=ref.title,
        summary=data["summary"],
        text=read_text(folder / layout.LESSON_TEXT),
        exercises=tuple(_exercise(folder, ref, item) for item in data["exercises"]),
        folder=folder,
    )


def lesson_of(chapter: Chapter) -> Lesson:
    return Lesson(ChapterRef(chapter.number, chapter.title, chapter.slug), chapter.text)


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


def _lesson(folder: Path) -> dict[str, Any]:
    from course.content.lesson import read_lesson  # imports YAML and pydantic, see cache.py

    reading = read_lesson(folder)
    if reading.data is None:
        raise reading.problems[0]
    return reading.data


def _exercise(folder: Path, ref: ChapterRef, data: dict[str, Any]) -> Exercise:
    return Exercise(
        id=data["id"],
        title=data["title"],
        summary=data["summary"],
        chapter=ref,
        text=read_text(layout.exercise_text(folder, data["id"])),
        hints=tuple(data["hints"]),
        after=data["after"],
        files=_files(data),
        packages=tuple(data["packages"]),
        workspace=data["workspace"],
        grader_packages=tuple(data["grader_packages"]),
        requires=tuple(data["requires"]),
        time_limit=float(data["time_limit"]),
        grader=layout.grader_file(folder),
        starter=layout.starter_folder(folder, data["id"]),
        solution=layout.solution_folder(folder),
        folder=folder,
        questions=tuple(question_of(item) for item in data["questions"]),
        play=layout.play_file(folder, data["id"]),
        looks_at=tuple(data["looks_at"]),
        bonus=data["bonus"],
        local_only=data["local_only"],
    )


def _files(data: dict[str, Any]) -> tuple[str, ...]:
    """The learner's files; with questions, the answers are one of them."""
    answers = [layout.answers_file(data["id"])] if data["questions"] else []
    return tuple(dict.fromkeys((*data["files"], *answers)))
