"""What the course itself gives: the code of starters and lessons, and its solutions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

from course.batch.similar.reading import Reader
from course.batch.similar.words import words_of
from course.batch.similar.work import File
from course.content import Course, Exercise
from course.content.layout import ALTERNATIVE

# Shorter than what counts as alike, so that own code around a line of the starter is not taken for given.
GIVEN = 16  # words in a row
_ALTERNATIVES = "alternatives"
_LANGUAGES = frozenset({"python", "cpp", "yaml", "xml"})

Given = frozenset[str]


def given_of(course: Course, reader: Reader, *, solutions: bool = False) -> Given:
    """The runs of GIVEN words in starters and lessons; with `solutions`, in those too."""
    exercises = course.exercises()
    folders = [exercise.starter for exercise in exercises]
    if solutions:
        folders += [exercise.solution for exercise in exercises]
    texts = [words.text for folder in _each(folders) for _, words in reader.read(_files(folder))[0]]
    texts += [words_of(code, language).text for language, code in _shown(exercises)]
    return frozenset(text[at : at + GIVEN] for text in texts for at in range(len(text) - GIVEN + 1))


def solutions_of(course: Course) -> dict[str, list[File]]:
    """The reference solution of each chapter, and each other right one, with the name that is shown."""
    found: dict[str, list[File]] = {}
    for folder in _each(exercise.solution for exercise in course.exercises()):
        for file in _files(folder):
            parts = Path(file.name).parts
            other = parts[0] == _ALTERNATIVES and len(parts) > 2
            name = f"solution {folder.name}{f' ({parts[1]})' if other else ''}"
            if parts[-1] != ALTERNATIVE:
                found.setdefault(name, []).append(file)
    return found


def _files(folder: Path) -> list[File]:
    return [File(str(path.relative_to(folder)), path) for path in folder.rglob("*") if path.is_file()]


def _each(folders: Iterable[Path]) -> list[Path]:
    return [folder for folder in dict.fromkeys(folders) if folder.is_dir()]


def _shown(exercises: Iterable[Exercise]) -> Iterator[tuple[str, str]]:
    """The code that lessons show: (language, code)."""
    from markdown_it import MarkdownIt

    for folder in _each(exercise.folder for exercise in exercises):
        for file in sorted(folder.glob("*.md")):
            for token in MarkdownIt().parse(file.read_text(encoding="utf-8")):
                language = token.info.split(" ")[0]
                if token.type == "fence" and language in _LANGUAGES:
                    yield language, token.content
