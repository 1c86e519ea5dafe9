"""Whether a machine may grade for a coordinator: it needs the same course, ROS, and containment."""

from __future__ import annotations

import hashlib
import os
import socket
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

import course
from course.content import layout, open_course
from course.errors import CourseError
from course.isolation import Level
from course.isolation.levels import obstacle_to
from course.rosenv import find_ros


@dataclass(frozen=True)
class Wanted:
    """What a coordinator requires of its workers.

    engine, lessons: digests of these files. course: root of the course, None for the worker's own.
    """

    version: str
    engine: str
    lessons: str
    course: str | None = None
    contained: bool = True

    @property
    def resource(self) -> str:
        """The resource that only suitable workers offer to Dask."""
        return f"{self}"


@dataclass(frozen=True)
class Unfit:
    """why: ends a sentence that begins with the worker's name. advice: the next step."""

    why: str
    advice: str


def wanted(course_root: Path | None, contained: bool) -> Wanted:
    """What this machine requires of the others. Raises UsageError if `course_root` is not a course."""
    root = str(course_root) if course_root else None
    return Wanted(course.__version__, engine_digest(), _lessons_digest(course_root), root, contained)


def unfit(asked: Wanted, engine: str) -> Unfit | None:
    """Why this machine may not grade for that coordinator; None if it may. engine: the one running here."""
    ours = _other_engine(asked, engine) or _other_lessons(asked)
    return ours or _no_ros() or (_not_contained() if asked.contained else None)


def host() -> str:
    return socket.gethostname()


def engine_digest() -> str:
    """A digest of the engine's files as they are now."""
    return _digest([Path(course.__file__).parent, Path(__file__).parent])


def _other_engine(asked: Wanted, engine: str) -> Unfit | None:
    if asked.version != course.__version__:
        why = f"has ros2course {course.__version__}, and the class is graded with {asked.version}"
        return Unfit(why, f"Install ros2course {asked.version} on it, then start the worker again.")
    if engine != asked.engine:
        return _other_files(f"ros2course {course.__version__}")
    return None


def _other_lessons(asked: Wanted) -> Unfit | None:
    try:
        lessons = _lessons_digest(Path(asked.course) if asked.course else None)
    except (CourseError, OSError) as error:
        advice = "Put the folder of --course in the same place on it, then start the worker again."
        return Unfit(f"cannot read the course: {error}", advice)
    return None if lessons == asked.lessons else _other_files("course")


def _other_files(what: str) -> Unfit:
    why = f"has a {what} whose files differ from those of the machine that asks"
    return Unfit(why, "Install the same there, from the same commit, then start the worker again.")


def _no_ros() -> Unfit | None:
    try:
        find_ros()
    except CourseError as error:
        advice = error.next_step or "`ros2course doctor` on it shows what is missing."
        return Unfit(f"has no ROS to grade with: {error.what}", advice)
    return None


def _not_contained() -> Unfit | None:
    obstacle = obstacle_to(Level.CONTAINED)
    if obstacle is None:
        return None
    advice = "`ros2course doctor` on it shows how to fix that; then start the worker again."
    return Unfit(f"cannot contain submissions: {obstacle}", advice)


def _lessons_digest(course_root: Path | None) -> str:
    root = open_course(course_root).root
    return _digest(root / part for part in layout.PARTS)


def _digest(folders: Iterable[Path]) -> str:
    hashed = hashlib.blake2b(digest_size=16)
    for folder in folders:
        for file in _files(folder):
            hashed.update(f"{folder.name}/{file.relative_to(folder)}\0{file.stat().st_size}\0".encode())
            hashed.update(file.read_bytes())
    return hashed.hexdigest()


def _files(folder: Path) -> Iterator[Path]:
    """All files, sorted. A course inside an installed engine is not part of the engine."""
    for place, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if name != "_course" and not _is_left_over(name))
        yield from (Path(place, name) for name in sorted(names) if not _is_left_over(name))


def _is_left_over(name: str) -> bool:
    return name.startswith(".") or name == "__pycache__" or name.endswith(".pyc")
