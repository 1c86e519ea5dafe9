"""The course home: the folder that plays `~` for a learner."""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from course.content.layout import WORKSPACE
from course.errors import StorageError, UsageError
from course.home.storage import inside, storing

SCHEMA_VERSION = 1
STATE = ".ros2course"
MARKER = "home.json"


@dataclass(frozen=True)
class CourseHome:
    """A folder made by `create_home`. `path` is absolute."""

    path: Path

    @property
    def state(self) -> Path:
        """What the course keeps for itself: progress, backups, the marker."""
        return self.path / STATE

    @property
    def workspace(self) -> Path:
        return self.path / WORKSPACE

    def seed(self) -> int:
        """The learner's own random number (63 bits), made once: what mysteries are drawn from."""
        return read_marker(self.path)

    @contextlib.contextmanager
    def lock(self) -> Iterator[None]:
        """One command at a time changes the files of a home; another one waits."""
        file = inside(self.path, f"{STATE}/lock")
        with storing("the course home cannot be written"):
            descriptor = os.open(file, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW | os.O_CLOEXEC, 0o644)
        try:
            with contextlib.suppress(OSError):  # a network disk without locks: then without
                fcntl.flock(descriptor, fcntl.LOCK_EX)
            yield
        finally:
            os.close(descriptor)  # unlocks


def is_home(path: Path) -> bool:
    """Whether `create_home` made this folder."""
    try:
        return (path / STATE / MARKER).is_file()
    except PermissionError:
        return False


def read_marker(path: Path) -> int:
    """The seed that the marker holds. Raises StorageError when it cannot be read, UsageError when too new."""
    file = path / STATE / MARKER
    with storing("the course home cannot be read"):
        content = file.read_bytes()
    try:
        marker = json.loads(content)
        schema, seed = int(marker["schema"]), int(marker["seed"])
    except (ValueError, KeyError, TypeError):
        raise StorageError(f"{file} is damaged", f"`ros2course init {path}` makes it anew") from None
    if schema > SCHEMA_VERSION:
        raise UsageError(f"{path} was made by a newer ros2course", "upgrade ros2course, then try again")
    return seed
