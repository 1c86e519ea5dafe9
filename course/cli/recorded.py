"""The recording that `check` keeps of each exercise in the course home."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from course.cli.words import typed
from course.errors import UsageError
from course.evidence.mcap_file import BadRecording, OtherFormat, load
from course.evidence.recording import Recording
from course.home import CourseHome
from course.report.activity import activity
from course.report.console import error_console


@dataclass(frozen=True)
class Recorded:
    """A recording, and the file that it was read from. size: of the file, in bytes."""

    recording: Recording
    file: Path
    size: int


def recording_file(home: CourseHome, exercise: str) -> Path:
    """Where the last recording of this exercise lies, once there is one."""
    return home.state / "evidence" / f"{exercise}.mcap"


def recorded(home: CourseHome, exercise: str) -> Recorded | None:
    """The last recording of this exercise; None when there is none. Raises as `read_recording` does."""
    file = recording_file(home, exercise)
    return read_recording(file, f"`{typed(f'check {exercise}')}` records anew.") if file.is_file() else None


def read_recording(file: Path, otherwise: str) -> Recorded:
    """Raises UsageError for what is no recording, or damaged; `otherwise` is then the next step."""
    try:
        with activity(error_console(), "reading the recording", quiet=True):
            return Recorded(load(file), file, file.stat().st_size)
    except OtherFormat:
        raise UsageError(f"{file} was recorded by another version of ros2course.", otherwise) from None
    except BadRecording:
        raise UsageError(f"{file} is damaged, or no recording of the course.", otherwise) from None
