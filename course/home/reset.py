"""Begins an exercise again, after moving the old files to a dated backup.

At every moment, the learner's work is in its place, in the backup, or in both, so a full disk or a killed
command loses nothing.
"""

from __future__ import annotations

import errno
import os
import shutil
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from course.content import Exercise, shared_files
from course.content.layout import ADDED_TO, STATE
from course.files import sweep, wipe
from course.home.course_home import CourseHome
from course.home.starter import starter_files
from course.home.storage import copy_into, copy_over, inside, storing


@dataclass(frozen=True)
class ResetReport:
    """What `reset` did; paths of files are relative to the course home.

    backup: the folder with the old files, arranged as in the home; None if there were none.
    saved: the files in it. restored: starter files that were copied again. removed: files that are not in
    the starter. kept: files that other exercises use too; they are saved, but not changed.
    """

    backup: Path | None
    saved: tuple[str, ...]
    restored: tuple[str, ...]
    removed: tuple[str, ...]
    kept: tuple[str, ...]


def reset(home: CourseHome, exercise: Exercise, *, now: datetime | None = None) -> ResetReport:
    """Put the exercise's files into a backup, and its starter in their place.

    Raises StorageError if the disk cannot be written; the learner's work is then in its place or the backup.
    """
    starter = starter_files(exercise)
    listed = tuple(dict.fromkeys((*starter, *exercise.files)))
    shared = shared_files(exercise) | ADDED_TO
    with home.lock():
        with storing(f"{exercise.id} cannot be reset"):
            there = tuple(file for file in listed if os.path.lexists(inside(home.path, file)))
            backup = _back_up(home, there, f"{now or datetime.now():%Y-%m-%dT%H-%M-%S}-{exercise.id}")
        gone = tuple(file for file in there if file not in starter and file not in shared)
        where = f"; the earlier files are in {backup}" if backup else ""
        with storing(f"{exercise.id} is only partly reset{where}"):
            _lay_anew(home, exercise.starter, starter)
            for file in gone:
                _remove(home.path / file)
    kept = tuple(file for file in there if file not in starter and file in shared)
    return ResetReport(backup, there, starter, gone, kept)


def _back_up(home: CourseHome, files: tuple[str, ...], name: str) -> Path | None:
    """Write the backup under another name and rename it, so that it is complete or absent."""
    if not files:
        return None
    part = inside(home.path, f"{STATE}/backups/unfinished")
    _remove(part)  # left by a killed command; we hold the home's lock
    try:
        for file in files:
            _copy(home.path / file, part / file)
        return _claim(part, name)
    except OSError:
        wipe(part)
        raise


def _copy(source: Path, target: Path) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    if source.is_dir() and not source.is_symlink():
        shutil.copytree(source, target, symlinks=True)
    else:
        copy_into(source, target)


def _claim(part: Path, name: str) -> Path:
    """Rename to an unused name, even if there is already a backup from the same second."""
    backup, number = part.with_name(name), 2
    while os.path.lexists(backup):
        backup, number = part.with_name(f"{name}-{number}"), number + 1
    return part.rename(backup)


def _lay_anew(home: CourseHome, starter: Path, files: tuple[str, ...]) -> None:
    for file in files:
        target = home.path / file
        target.parent.mkdir(parents=True, exist_ok=True)
        sweep(target.parent)
        if target.is_dir() and not target.is_symlink():
            _remove(target)
        copy_over(starter / file, target)


def _remove(path: Path) -> None:
    wipe(path)
    if os.path.lexists(path):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), str(path))
