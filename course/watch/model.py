"""What the parts of `watch` tell one another: what happened, and what is to be seen."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from course.content import Exercise, Lesson
from course.content.question import Question
from course.grading.result import Result
from course.report.overview import Row
from course.watch.changes import Change


@dataclass(frozen=True)
class Task:
    """What is checked, in which home. course: its folder. number: tells one check from the next."""

    number: int
    course: str
    home: str
    exercise: str
    namespaces: bool = True


@dataclass(frozen=True)
class Said:
    """What the check is doing now."""

    number: int
    text: str


@dataclass(frozen=True)
class Checked:
    """The check came to a result."""

    number: int
    result: Result


@dataclass(frozen=True)
class Stuck:
    """There is no result: this machine lacks something, or the course home cannot be read."""

    number: int
    what: str
    next_step: str = ""


Message = Said | Checked | Stuck


@dataclass(frozen=True)
class Saved:
    """Files of the course home that were written or removed, relative to it."""

    files: tuple[str, ...]


@dataclass(frozen=True)
class Key:
    """A key that was pressed, as the character it writes."""

    name: str


@dataclass(frozen=True)
class Signal:
    """A signal to this process."""

    number: int


@dataclass(frozen=True)
class Tick:
    """Time has gone by."""


Event = Said | Checked | Stuck | Saved | Key | Signal | Tick


# ------------------------------------------------------------------------------- what fills the screen


@dataclass(frozen=True)
class LessonText:
    """What is read before an exercise: its chapter's lesson, and any before that without exercises."""

    exercise: Exercise
    lessons: tuple[Lesson, ...]


@dataclass(frozen=True)
class TaskText:
    """An exercise's task. new: its files that were laid just now. needed: what it stands on, not passed.

    questions: as this learner is asked them.
    """

    exercise: Exercise
    home: Path
    state: str
    new: tuple[Path, ...] = ()
    needed: tuple[str, ...] = ()
    questions: tuple[Question, ...] = ()


@dataclass(frozen=True)
class Verdict:
    """A result, and what changed since the one before. log: where a fault of ours was written down."""

    exercise: Exercise
    result: Result
    previous: Result | None
    change: Change | None
    log: Path | None = None


@dataclass(frozen=True)
class Problem:
    """Why there is no result."""

    what: str
    next_step: str


@dataclass(frozen=True)
class HintText:
    """Hint `number` of `total`, from 1; number 0 where there are none."""

    exercise: Exercise
    number: int
    total: int
    text: str = ""


@dataclass(frozen=True)
class Listing:
    """All exercises."""

    rows: tuple[Row, ...]
    chapters: tuple[str, ...] = ()


@dataclass(frozen=True)
class AllPassed:
    """There is no next exercise."""


Body = LessonText | TaskText | Verdict | Problem | HintText | Listing | AllPassed


@dataclass(frozen=True)
class Look:
    """What is to be seen. doing: what the check does, since when; empty while none runs.

    remark: what happened last. first: the first line of the body that is shown; None leaves it to the screen.
    """

    exercise: Exercise
    body: Body
    result: Result | None = None
    change: Change | None = None
    doing: str = ""
    since: float = 0.0
    remark: str = ""
    first: int | None = None


# ------------------------------------------------------------------------------- whom the session asks


@dataclass(frozen=True)
class Begun:
    """An exercise that is ready to be worked on; new: the files that were laid for it."""

    exercise: Exercise
    new: tuple[Path, ...] = ()
    first_of_chapter: bool = False


class Learner(Protocol):
    """The learner's place in the course: what commands do beside showing something."""

    @property
    def home(self) -> Path: ...

    def next(self) -> Begun | None:
        """Begin what comes next, as `next` does; None when everything is passed."""

    def lesson(self, exercise: Exercise) -> LessonText: ...

    def task(self, begun: Begun) -> TaskText: ...

    def hint(self, exercise: Exercise) -> HintText:
        """One further each time, as `hint` does."""

    def listing(self) -> Listing: ...

    def is_passed(self, exercise: Exercise) -> bool: ...

    def last_result(self, exercise: Exercise) -> Result | None: ...

    def remember(self, exercise: Exercise, result: Result) -> Path | None:
        """Store it, as `check` does. Returns where a fault of ours was written down."""

    def ask(self, exercise: Exercise) -> None:
        """Ask the questions of a quiz on the terminal, which is free for that."""


class Checking(Protocol):
    """Runs one check at a time."""

    def start(self, exercise: Exercise) -> int:
        """Begin one; one that runs is called off. Returns the number that its messages carry."""

    def stop(self) -> None:
        """Call off the one that runs, if any."""
