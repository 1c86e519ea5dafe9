"""A mutant of a grader, what became of it, and the whole of a mutation run."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from pathlib import Path

from course.validate.proofs import Proof


class Operator(str, Enum):
    """What was done to the grader."""

    RETURN = "returns early"
    RAISE = "a failure removed"
    EXPECT = "an expectation removed"
    BOUND = "a bound made wider"
    BOUNDARY = "a boundary moved by one"
    COMPARISON = "a comparison turned around"
    NOT = "`not` removed"
    AND_OR = "`and` and `or` swapped"


class Fate(str, Enum):
    """What became of a mutant. All but SURVIVED were noticed.

    BROKEN: it could not be imported, or ran into an error of its own. ENDLESS: it did not end.
    """

    KILLED = "killed"
    SURVIVED = "survived"
    BROKEN = "broken"
    ENDLESS = "endless"


@dataclass(frozen=True)
class Change:
    """One change of a module's text, in bytes of UTF-8. It keeps the number of lines.

    bounds: of a bound, what it was and what it is now.
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

    before, after: what was changed, with what is around it in its lines; each in one line. text: of the file,
    as it was when the mutant was made: someone may write it meanwhile.
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
    """A mutant, and by what it was noticed: one line; empty for a survivor."""

    mutant: Mutant
    fate: Fate
    by: str = ""


@dataclass(frozen=True)
class OfExercise:
    """What came of one exercise. problems: why its grader could not be mutated; it is proven first.

    recorded: how many recordings were made now, the others were kept. recording, judging: seconds.
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
    """Of each exercise that has a grader, what came of it."""

    exercises: tuple[OfExercise, ...]

    @property
    def sound(self) -> bool:
        """Whether every mutant was noticed, and every grader could be mutated."""
        return not any(one.problems or one.survivors for one in self.exercises)


@dataclass(frozen=True)
class Step:
    """How far it is. stage: what is done; done, total: of it. judged: the mutant that is done, if one is."""

    exercise: str
    stage: str
    done: int
    total: int
    judged: Judged | None = None


@dataclass(frozen=True)
class Evidence:
    """A proof with its recording, and the result that it led to: paths of the two files."""

    proof: Proof
    recording: str
    result: str


@dataclass(frozen=True)
class Mutated:
    """A change of the grader's text, as in `Change`; and the checks that use what it changes."""

    start: int
    end: int
    new: str
    checks: tuple[str, ...]


@dataclass(frozen=True)
class Case:
    """All mutants of one exercise. course: its root. folder: an empty one, for the mutants' files.

    text: of the grader, which the mutants' changes are of. jobs: mutants at once. seconds: of a CPU, for one.
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
    """What became of a mutant. index: among those of the case."""

    index: int
    fate: Fate
    by: str
