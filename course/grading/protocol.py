"""What the grading's processes say to each other: one JSON object a line.

The recording process gets a task and tells what it does, and last how it ended. A judging process gets
portions of recordings and gives one answer for each.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from enum import Enum

from msgspec import Struct, field

from course.evidence.packages import BuiltPackages
from course.isolation.isolation_plan import IsolationPlan
from course.model import codec
from course.model.feedback import Feedback
from course.model.result import CheckResult, Doubt

# Seconds for one recording; nearly all take milliseconds.
MOST_TIME = 60
# So many share one collection by pytest (some 50 ms), and at most so many reports that it keeps.
PORTION = 50


class RecordingTask(Struct, frozen=True):
    """One exercise to record.

    home: the course home whose files are read. roots: the files and folders of it that belong
    to the exercise. environment: for the learner's programs. python: their interpreter.
    looks_at: files, folders and patterns of the course home that become evidence. plain: the environment
    of programs that need no ROS. local: False when a submission is graded. seed: the exercise's own, for
    its mystery. acts: name and detail of what the learner did while it was played. sandbox: what their
    programs are confined to, or None.
    """

    exercise: str
    grader: str
    home: str
    roots: tuple[str, ...]
    packages: BuiltPackages
    environment: Mapping[str, str]
    python: str
    looks_at: tuple[str, ...] = ()
    plain: Mapping[str, str] = field(default_factory=dict)
    local: bool = True
    seed: int | None = None
    acts: tuple[tuple[str, str], ...] = ()
    sandbox: IsolationPlan | None = None
    observed: bool = False


class Fork(Struct, frozen=True):
    """A recording process to start. environment: its own. folder: for scratch files.

    holder: pid of a process whose namespaces it enters; None where there are none.
    """

    environment: Mapping[str, str]
    folder: str
    holder: int | None = None


class Stage(Struct, frozen=True, tag_field="kind", tag="stage"):
    """What the recording process is doing, in words. running: the submission's programs run from now on."""

    text: str
    running: bool = False


class RecordingOutcome(Struct, frozen=True, tag_field="kind", tag="outcome"):
    """How a recording ended. seconds: that the scenario took. lag, cpu: see `result.Timing`.

    fault: why there is no recording. doubt: set with a fault where another attempt may end differently.
    missing: True when `fault` is something that this machine lacks, with what installs it as its advice.
    """

    seconds: float = 0.0
    fault: Feedback | None = None
    doubt: Doubt | None = None
    lag: float = 0.0
    cpu: float = 0.0
    missing: bool = False


class Judgment(Struct, frozen=True):
    """What the checks say of a recording. fault: why they say nothing. doubt: as of a result."""

    checks: tuple[CheckResult, ...]
    fault: Feedback | None = None
    doubt: Doubt | None = None


class Portion(Struct, frozen=True):
    """Recordings whose checks are in one module. looks_at: by exercise. files: (exercise, path).

    Without files, it says which grader will be needed.
    """

    grader: str
    looks_at: Mapping[str, tuple[str, ...]]
    files: tuple[tuple[str, str], ...]


class UnjudgedCause(str, Enum):
    """Why a recording cannot be judged.

    FORMAT: it is whole, but of another version of the course. EXERCISE: of another one than was said.
    FATAL: the process that judged it died of it, or did not end.
    """

    MISSING = "missing"
    DAMAGED = "damaged"
    FORMAT = "of another format"
    EXERCISE = "of another exercise"
    FATAL = "cannot be judged"


class Unjudged(Struct, frozen=True, tag_field="kind", tag="unjudged"):
    """A recording that was not judged. what: one line for the instructor, without its path."""

    cause: UnjudgedCause
    what: str


class ScenarioState(str, Enum):
    """Whether today's scenario would record the same (see `scenario_digest`).

    UNKNOWN: the recording does not say what made it.
    """

    SAME = "same"
    CHANGED = "changed"
    UNKNOWN = "unknown"


class Judged(Struct, frozen=True, tag_field="kind", tag="judged"):
    """What the checks of now say of a recording."""

    judgment: Judgment
    scenario: ScenarioState


class Channel:
    """The recording process's end. Messages beyond what the pipe takes at once block until they are read."""

    def __init__(self, descriptor: int) -> None:
        self._descriptor = descriptor

    def tell(self, message: Stage | RecordingOutcome) -> None:
        rest = codec.to_json(message) + b"\n"
        while rest:
            rest = rest[os.write(self._descriptor, rest) :]


def read_message(line: bytes) -> Stage | RecordingOutcome:
    """A line of the recording process. Raises DamagedData on anything else."""
    message: Stage | RecordingOutcome = codec.from_json(line, Stage | RecordingOutcome, "this line")
    return message


def read_answer(line: bytes) -> Judged | Unjudged:
    """What a judging process says of one recording. Raises DamagedData on anything else."""
    answer: Judged | Unjudged = codec.from_json(line, Judged | Unjudged, "this line")
    return answer
