"""What a learner is told if their work did not pass: data, never concatenated text.

Nearly every module creates feedback, so this one imports none of them.
"""

from __future__ import annotations

from msgspec import Struct


class Location(Struct, frozen=True):
    """A place in the learner's files. `file` is relative to the course home; `line` counts from 1."""

    file: str
    line: int | None = None

    def __str__(self) -> str:
        return f"{self.file}:{self.line}" if self.line else self.file


class Feedback(Struct, frozen=True):
    """Why a check did not pass, as data.

    summary: one sentence that names the cause.
    expected, seen: short phrases, if a comparison helps.
    where: places in the learner's files, most useful first.
    advice: what to do next, in one or two sentences; may contain `code` in backquotes.
    details: lines of evidence (a shortened log, traceback or list), shown as they are.
    """

    summary: str
    expected: str | None = None
    seen: str | None = None
    where: tuple[Location, ...] = ()
    advice: str | None = None
    details: tuple[str, ...] = ()


class Pace(Struct, frozen=True):
    """How often a check wants messages: the allowed median time (s) between two of them on `topic`."""

    topic: str
    shortest: float
    longest: float


class NotApplicable(Exception):
    """Raised by a check that cannot be judged here, through nobody's fault; it does not affect the verdict.

    because: one sentence for the learner, such as what this machine lacks.
    """

    def __init__(self, because: str) -> None:
        super().__init__(because)
        self.because = because


class Spoilt(Exception):
    """The recording shows a problem that, as far as anyone can tell, is not the learner's fault.

    Another attempt decides, because a submission may have caused it. See `course.grading.attempts`.
    """


class TooBusy(Spoilt):
    """The machine was too busy. Submissions cannot affect this measurement, so they are never blamed."""


class Failure(Exception):
    """The learner's work does not do what the task asks; carries the feedback that says so.

    Only a `Failure` blames the learner. Any other exception in a check is our error.
    """

    def __init__(self, feedback: Feedback) -> None:
        super().__init__(feedback.summary)
        self.feedback = feedback


class DoubtfulFailure(Failure):
    """A failure that ROS itself may have caused, in rare cases. It counts if each attempt ends with one."""
