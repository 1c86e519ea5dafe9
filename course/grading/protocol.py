"""The messages between the processes that grade: one JSON object per line.

The recording process gets a task, and reports what it is doing and, finally, how it ended. A judging process
gets portions of recordings, and gives one answer for each recording.
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum

from msgspec import Struct, field

from course.evidence.packages import BuiltPackages
from course.isolation.isolation_plan import IsolationPlan
from course.model import codec
from course.model.feedback import Feedback
from course.model.result import CheckResult, Doubt

# Seconds to judge one recording; nearly all take milliseconds.
MOST_TIME = 60
# Recordings for which pytest collects once (about 50 ms), and of which it keeps all reports.
PORTION = 50


class RecordingTask(Struct, frozen=True):
    """One exercise to record.

    home: the course home whose files are read. roots: the files and folders in it that belong
    to the exercise. environment: for the learner's programs. python: their interpreter.
    looks_at: files, folders and patterns of the course home that become evidence. plain: the environment
    of programs that need no ROS. local: False if a submission is graded. seed: the exercise's own, for
    its mystery. acts: name and detail of what the learner did while playing it. sandbox: what confines
    their programs, or None. observed: whether to watch them from inside.
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

    holder: pid of a process whose namespaces it enters; None if there are none.
    """

    environment: Mapping[str, str]
    folder: str
    holder: int | None = None


class Stage(Struct, frozen=True, tag_field="kind", tag="stage"):
    """What the recording process is doing, in words. running: whether the submission's programs now run."""

    text: str
    running: bool = False


class RecordingOutcome(Struct, frozen=True, tag_field="kind", tag="outcome"):
    """How a recording ended. seconds: how long the scenario took. lag, cpu: see `result.Timing`.

    fault: why there is no recording. doubt: set with a fault if another attempt may end differently.
    missing: True if `fault` is something that this machine lacks; its advice says how to install it.
    """

    seconds: float = 0.0
    fault: Feedback | None = None
    doubt: Doubt | None = None
    lag: float = 0.0
    cpu: float = 0.0
    missing: bool = False


class Judgment(Struct, frozen=True):
    """What the checks say about a recording. fault: why they say nothing. doubt: as in a result."""

    checks: tuple[CheckResult, ...]
    fault: Feedback | None = None
    doubt: Doubt | None = None


class Portion(Struct, frozen=True):
    """Recordings whose checks are in one module. looks_at: by exercise. files: (exercise, path).

    Without files, it only announces which grader will be needed.
    """

    grader: str
    looks_at: Mapping[str, tuple[str, ...]]
    files: tuple[tuple[str, str], ...]


class UnjudgedCause(str, Enum):
    """Why a recording cannot be judged.

    FORMAT: it is intact, but from another version of the course. EXERCISE: it is from a different exercise
    than expected. FATAL: it made the process that judged it crash or hang.
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
    """Whether the current scenario would record the same (see `scenario_digest`).

    UNKNOWN: the recording does not say which scenario made it.
    """

    SAME = "same"
    CHANGED = "changed"
    UNKNOWN = "unknown"


class Judged(Struct, frozen=True, tag_field="kind", tag="judged"):
    """What the current checks say about a recording."""

    judgment: Judgment
    scenario: ScenarioState


def tell(descriptor: int, message: Stage | RecordingOutcome) -> None:
    """Send it from the recording process. When the pipe is full, this blocks until it is read."""
    with open(descriptor, "wb", closefd=False) as stream:
        stream.write(codec.to_json(message) + b"\n")


def read_message(line: bytes) -> Stage | RecordingOutcome:
    """A line from the recording process. Raises DamagedData on anything else."""
    message: Stage | RecordingOutcome = codec.from_json(line, Stage | RecordingOutcome, "this line")
    return message


def read_answer(line: bytes) -> Judged | Unjudged:
    """What a judging process says about one recording. Raises DamagedData on anything else."""
    answer: Judged | Unjudged = codec.from_json(line, Judged | Unjudged, "this line")
    return answer
