"""Every error that the course raises on purpose, and the exit code of each.

CourseError            what happened, and the next step
├── UsageError         the command was called with something that does not exist or does not fit (exit 2)
├── OurFault           the course itself is broken; never the learner's failure (exit 3)
│   └── ContentError   a lesson, grader or mistake file is wrong; says file, line and key
├── MissingHere        this machine lacks something: ROS, a compiler, a wheel (exit 4)
└── StorageError       a file could not be written or read: full, read-only, no permission (exit 4)
    └── DamagedData    data is unreadable or was changed; says where it came from (exit 4)

Only `course/cli` turns these into a message and an exit code.
"""

from __future__ import annotations

from enum import IntEnum
from pathlib import Path
from typing import ClassVar


class ExitCode(IntEnum):
    """The exit code of the process; documented in `ros2course --help`."""

    PASSED = 0
    NOT_PASSED = 1
    USAGE = 2
    OUR_FAULT = 3
    MISSING_HERE = 4
    INTERRUPTED = 130


class CourseError(Exception):
    """Something went wrong that a person can act on.

    `what` is one sentence about what happened; `next_step` says what to do about it.
    """

    exit_code: ClassVar[ExitCode] = ExitCode.OUR_FAULT

    def __init__(self, what: str, next_step: str | None = None) -> None:
        super().__init__(what)
        self.what = what
        self.next_step = next_step


class UsageError(CourseError):
    """The command was called with something that does not exist or does not fit."""

    exit_code = ExitCode.USAGE


class OurFault(CourseError):
    """The course is broken here; the learner did nothing wrong."""

    exit_code = ExitCode.OUR_FAULT


class ContentError(OurFault):
    """A file of the course is wrong: `file`, and `line` (from 1) and `key` if they are known."""

    def __init__(
        self,
        what: str,
        next_step: str | None = None,
        *,
        file: Path,
        line: int | None = None,
        key: str | None = None,
    ) -> None:
        super().__init__(what, next_step)
        self.file = file
        self.line = line
        self.key = key

    def __str__(self) -> str:
        place = f"{self.file}:{self.line}" if self.line else str(self.file)
        key = f" ({self.key})" if self.key else ""
        return f"{place}{key}: {self.what}"


class MissingHere(CourseError):
    """This machine lacks something; `next_step` says how to get it."""

    exit_code = ExitCode.MISSING_HERE


class StorageError(CourseError):
    """A file could not be written or read: disk full, read-only, no permission."""

    exit_code = ExitCode.MISSING_HERE


class DamagedData(StorageError):
    """Data from a file, database or other process is unreadable; says where it came from."""
