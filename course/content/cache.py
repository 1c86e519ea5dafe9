"""Remembers lesson files that were found right, so that a command need not prove it again.

Reading YAML and checking it with pydantic costs about 0.15 s, most of it imports, which every `hint`
would pay. A lesson is kept as JSON together with a hash of the file and of the rules it was checked by:
when either changes it is read anew. Anything odd about the cache means reading the lesson anew.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from course.content.layout import LESSON

Lesson = dict[str, Any]
_RULES = (
    "schema.py",
    "schema_parts.py",
    "question_schema.py",
    "question_problems.py",
    "explain.py",
    "lesson.py",
)


@dataclass(frozen=True)
class LessonCache:
    """Lessons kept in `folder`, one small file for each chapter."""

    folder: Path

    def get(self, chapter: Path, read: Callable[[], Lesson]) -> Lesson:
        """The chapter's lesson: the kept one if it still holds, else what `read` gives or raises."""
        try:
            proof = _proof(chapter)  # before reading: a file that changes meanwhile must not be kept as read
        except OSError:
            return read()
        kept = self._kept(chapter, proof)
        if kept is not None:
            return kept
        lesson = read()
        self._keep(chapter, proof, lesson)
        return lesson

    def _kept(self, chapter: Path, proof: str) -> Lesson | None:
        try:
            kept = json.loads(self._file(chapter).read_text(encoding="utf-8"))
            lesson = kept["lesson"] if kept["proof"] == proof else None
        except (OSError, ValueError, KeyError, TypeError):
            return None
        return lesson if isinstance(lesson, dict) else None

    def _keep(self, chapter: Path, proof: str, lesson: Lesson) -> None:
        """A full or read-only disk only costs time at the next command."""
        file = self._file(chapter)
        part = file.with_name(f"{file.name}.{os.getpid()}.part")
        try:
            file.parent.mkdir(parents=True, exist_ok=True)
            part.write_text(json.dumps({"proof": proof, "lesson": lesson}), encoding="utf-8")
            part.replace(file)
        except OSError:
            with contextlib.suppress(OSError):
                part.unlink(missing_ok=True)

    def _file(self, chapter: Path) -> Path:
        place = hashlib.sha256(os.fsencode(chapter.resolve())).hexdigest()[:16]
        return self.folder / f"{chapter.name}-{place}.json"


def _proof(chapter: Path) -> str:
    """A hash of all that decides what reading this lesson gives."""
    here = Path(__file__).parent
    parts = [chapter / LESSON, *(here / name for name in _RULES)]
    return hashlib.sha256(b"\0".join(part.read_bytes() for part in parts)).hexdigest()
