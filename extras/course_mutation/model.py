"""A mutant of a grader, its fate, and a whole mutation run."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from pathlib import Path

from course.validate.proofs import Proof


class Operator(str, Enum):
    """How the grader was changed."""

    RETURN = "returns early"
    RAISE = "a failure removed"
    EXPECT = "an expectation removed"
    BOUND = "a bound made wider"
    BOUNDARY = "a boundary moved by one"
    COMPARISON = "a comparison turned around"
    NOT = "`not` removed"
    AND_OR = "`and` and `or` swapped"


class Fate(str, Enum):
    """A mutant's fate. All but SURVIVED were noticed.

    BROKEN: it could not be imported, or raised an error. ENDLESS: it did not end.
    """

    KILLED = "killed"
    SURVIVED = "survived"
    BROKEN = "broken"
    ENDLESS = "endless"


@dataclass(frozen=True)
class Change:
    """One change of a module's text, in bytes of UTF-8. It keeps the number of lines.

    bounds: the old and the new limit, if one was changed.
    """

    operator: Operator
    start: int
    end: int
    new: bytes
    bounds: tuple[float, float] | None = None

    def applied(self, text: bytes) -> bytes:
        return text[: self.start] + self.new + text[self.end :]


@dataclass(frozen=True)
class Mutant:
    """A grader with one change. line: from 1. function: which was changed. checks: ids of those that use it.

    before, after: the changed lines, each as a single line. text: the file's text when the mutant was made,
    because someone may edit the file meanwhile.
    """

    exercise: str
    file: Path
    line: int
    function: str
    checks: tuple[str, ...]
    change: Change
    before: str
    after: str
    text: bytes = field(default=b"", repr=False, compare=False)


@dataclass(frozen=True)
class Judged:
    """A mutant, and what noticed it, in one line; empty for a survivor."""

    mutant: Mutant
    fate: Fate
    by: str = ""


@dataclass(frozen=True)
class OfExercise:
    """The result for one exercise. problems: why its grader could not be mutated; proofs come first.

    recorded: how many recordings were made now; the others were kept. recording, judging: seconds.
    """

    exercise: str
    judged: tuple[Judged, ...] = ()
    problems: tuple[str, ...] = ()
    recorded: int = 0
    kept: int = 0
    recording: float = 0.0
    judging: float = 0.0

    def count(self, *fates: Fate) -> int:
        return sum(one.fate in fates for one in self.judged)

    @property
    def survivors(self) -> tuple[Judged, ...]:
        return tuple(one for one in self.judged if one.fate is Fate.SURVIVED)


@dataclass(frozen=True)
class Mutation:
    """The result for each exercise that has a grader."""

    exercises: tuple[OfExercise, ...]

    @property
    def sound(self) -> bool:
        """Whether every mutant was noticed, and every grader could be mutated."""
        return not any(one.problems or one.survivors for one in self.exercises)


@dataclass(frozen=True)
class Step:
    """Progress. stage: the current work, with `done` of `total`. judged: the mutant just finished, if any."""

    exercise: str
    stage: str
    done: int
    total: int
    judged: Judged | None = None


@dataclass(frozen=True)
class Evidence:
    """A proof with the paths of its recording and of its result."""

    proof: Proof
    recording: str
    result: str


@dataclass(frozen=True)
class Mutated:
    """A change of the grader's text, as in `Change`, and the checks that it affects."""

    start: int
    end: int
    new: str
    checks: tuple[str, ...]


@dataclass(frozen=True)
class Case:
    """All mutants of one exercise. course: its root. folder: an empty folder for the mutants' files.

    text: the grader's text, to which the changes apply. jobs: mutants at once. seconds: CPU time for each.
    """

    course: str
    exercise: str
    folder: str
    text: str
    evidence: tuple[Evidence, ...]
    mutants: tuple[Mutated, ...]
    jobs: int
    seconds: float


@dataclass(frozen=True)
class Ended:
    """A mutant's fate. index: its place in the case."""

    index: int
    fate: Fate
    by: str
