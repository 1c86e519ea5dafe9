"""Lays a submission out as a fresh course home: copies of ordinary files, nothing else."""

from __future__ import annotations

import os
from pathlib import Path

from course.batch.intake.model import Found
from course.batch.intake.plan import made_of
from course.batch.intake.recognise import SRC
from course.batch.intake.tree import Entry, read_tree
from course.home.opening import USUAL, Finding, Limits, Notes
from course.home.opening.unpack import BOTH, made_whole
from course.home.storage import storing

_STEP = 1 << 18
UNREADABLE = "Files that may not be read were left out."


def lay_out(found: Found, home: Path, limits: Limits = USUAL) -> tuple[Finding, ...]:
    """Make the folder `home`, whole or not at all; returns what was left out and `look` did not tell.

    There is always a `ros2_tutorial_workspace/src`. Modes are 644, or 755 for programs and folders.
    Raises StorageError when the disk does not take it, or when something is at `home` already; Refused
    when the submission has grown meanwhile.
    """
    notes = Notes()
    with storing(f"the submission of {found.person.id} cannot be laid out"), made_whole(home) as part:
        (part / SRC).mkdir(parents=True)
        for target, entry in made_of(read_tree(found.parts, limits), found.places):
            _lay(entry, part / target, target, notes)
        part.chmod(0o755)
    return notes.findings()


def _lay(entry: Entry, target: Path, name: str, notes: Notes) -> None:
    try:
        if entry.folder:
            target.mkdir(parents=True, exist_ok=True)
            return
        target.parent.mkdir(parents=True, exist_ok=True)
        target.touch(exist_ok=False)
    except (NotADirectoryError, FileExistsError):
        notes.add(BOTH, name)
        return
    try:
        descriptor = os.open(entry.path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
    except OSError:
        target.unlink()
        notes.add(UNREADABLE, name)
    else:
        _copy(descriptor, target, entry)


def _copy(descriptor: int, target: Path, entry: Entry) -> None:
    """No more than was seen of the file, whatever became of it since."""
    with os.fdopen(descriptor, "rb") as source, target.open("wb") as out:
        left = entry.size
        while left > 0 and (data := source.read(min(_STEP, left))):
            left -= len(data)
            out.write(data)
    target.chmod(0o755 if entry.executable else 0o644)
