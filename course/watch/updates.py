"""What the parts of `watch` tell one another: what happened, what changed, and what to show."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from msgspec import Struct

from course.content import Exercise, Lesson
from course.content.entries import Question
from course.model.result import CheckResult, Outcome, Result
from course.report.exercise_text import ExerciseRow


@dataclass(frozen=True)
class ResultChange:
    """fixed: titles of checks that pass now and did not before. broken: those that no longer pass.

    points: the difference; negative if there are fewer.
    """

    fixed: tuple[str, ...]
    broken: tuple[str, ...]
    points: float

    @property
    def is_nothing(self) -> bool:
        return not (self.fixed or self.broken or self.points)


def what_changed(before: Result | None, now: Result) -> ResultChange | None:
    """None if there is nothing to compare with. Checks that only one of the two has are left out."""
    if before is None or before.exercise != now.exercise:
        return None
    passed = {check.id: check.outcome is Outcome.PASSED for check in before.checks}
    known = [check for check in now.checks if check.id in passed]
    return ResultChange(
        fixed=_titles(check for check in known if _passes(check) and not passed[check.id]),
        broken=_titles(check for check in known if not _passes(check) and passed[check.id]),
        points=now.points - before.points,
    )


def _passes(check: CheckResult) -> bool:
    return check.outcome is Outcome.PASSED


def _titles(checks: Iterable[CheckResult]) -> tuple[str, ...]:
    return tuple(check.title for check in checks)


class CheckTask(Struct, frozen=True):
    """What to check, and in which home. course: its folder. number: different for each check."""

    number: int
    course: str
    home: str
    exercise: str
    namespaces: bool = True


class Said(Struct, frozen=True, tag_field="kind", tag="said"):
    """What the check is doing now."""

    number: int
    text: str


class SoFar(Struct, frozen=True, tag_field="kind", tag="so far"):
    """The check's result, while the cause of a failure is still unknown."""

    number: int
    result: Result


class Checked(Struct, frozen=True, tag_field="kind", tag="checked"):
    """The check's final result."""

    number: int
    result: Result


class Stuck(Struct, frozen=True, tag_field="kind", tag="stuck"):
    """There is no result: this machine lacks something, or the course home cannot be read."""

    number: int
    what: str
    next_step: str = ""


Message = Said | SoFar | Checked | Stuck


@dataclass(frozen=True)
class Saved:
    """Files of the course home that were written or removed, relative to it."""

    files: tuple[str, ...]


@dataclass(frozen=True)
class Key:
    """A key that was pressed, as the character that it types."""

    name: str


@dataclass(frozen=True)
class SignalCame:
    """A signal to this process."""

    number: int


@dataclass(frozen=True)
class Tick:
    """A second has passed."""


Event = Said | SoFar | Checked | Stuck | Saved | Key | SignalCame | Tick


# ------------------------------------------------------------------------------- what fills the screen


@dataclass(frozen=True)
class LessonText:
    """What to read before an exercise: its part of the lesson, and earlier chapters without exercises."""

    exercise: Exercise
    lessons: tuple[Lesson, ...]


@dataclass(frozen=True)
class TaskText:
    """An exercise's task. new: files that were just copied. needed: what it builds on that is not passed.

    questions: in the form in which this learner is asked.
    """

    exercise: Exercise
    home: Path
    state: str
    new: tuple[Path, ...] = ()
    needed: tuple[str, ...] = ()
    questions: tuple[Question, ...] = ()


@dataclass(frozen=True)
class ResultText:
    """A result, and what changed since the one before. log: the file with details of a fault of ours."""

    exercise: Exercise
    result: Result
    previous: Result | None
    change: ResultChange | None
    log: Path | None = None


@dataclass(frozen=True)
class ProblemText:
    """Why there is no result."""

    what: str
    next_step: str


@dataclass(frozen=True)
class HintText:
    """Hint `number` of `total`, from 1; 0 if there are no hints."""

    exercise: Exercise
    number: int
    total: int
    text: str = ""


@dataclass(frozen=True)
class Listing:
    """All exercises."""

    rows: tuple[ExerciseRow, ...]
    chapters: tuple[str, ...] = ()


@dataclass(frozen=True)
class AllPassed:
    """There is no next exercise."""


Body = LessonText | TaskText | ResultText | ProblemText | HintText | Listing | AllPassed


@dataclass(frozen=True)
class Look:
    """What to show. doing: what the check is doing; empty if none is running. since: when that began.

    remark: what happened last. first: the body's first line to show; None leaves it to the screen.
    """

    exercise: Exercise
    body: Body
    result: Result | None = None
    change: ResultChange | None = None
    doing: str = ""
    since: float = 0.0
    remark: str = ""
    first: int | None = None


# ------------------------------------------------------------------------------- whom the session asks


@dataclass(frozen=True)
class Begun:
    """An exercise that is ready to be worked on. new: the files that were copied for it."""

    exercise: Exercise
    new: tuple[Path, ...] = ()
    to_read: bool = False


class Learner(Protocol):
    """The learner's progress in the course: what commands do, apart from showing something."""

    @property
    def home(self) -> Path: ...

    def next(self) -> Begun | None:
        """Begin the next exercise, as `next` does; None if everything is passed."""

    def lesson(self, exercise: Exercise) -> LessonText: ...

    def task(self, begun: Begun) -> TaskText: ...

    def hint(self, exercise: Exercise) -> HintText:
        """The next hint each time, as `hint` does."""

    def listing(self) -> Listing: ...

    def is_passed(self, exercise: Exercise) -> bool: ...

    def last_result(self, exercise: Exercise) -> Result | None: ...

    def remember(self, exercise: Exercise, result: Result) -> Path | None:
        """Store it, as `check` does. Returns the file with details of a fault of ours."""

    def ask(self, exercise: Exercise) -> None:
        """Ask the questions of a quiz on the terminal, which nothing else uses meanwhile."""
