"""Results, gradings and submissions as data."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from course.batch.gradings import Graded, Unit
from course.batch.results import Submission
from course.model.result import CheckResult, Feedback, Outcome, Result, Timing, Verdict

SHINES = CheckResult("shines", "It shines", 2, Outcome.PASSED)
DARK = CheckResult("shines", "It shines", 2, Outcome.FAILED, feedback=Feedback("It is dark."))
PASSED = Result("04-light", Verdict.PASSED, (SHINES,), containment="contained")
FAILED = Result("04-light", Verdict.NOT_PASSED, (DARK,), containment="contained")
OURS = Result("04-light", Verdict.OUR_ERROR, fault=Feedback("The grader fell over."))
QUIZ = "05-quiz"


def graded(person: str, result: Result = PASSED, attempt: int = 1) -> Graded:
    return Graded(Unit(person, result.exercise, attempt), result, 1.5)


def submissions(*people: str, digest: str = "d1") -> list[Submission]:
    late = ("It is late.",)
    return [Submission(person, person.title(), f"{person}.zip", digest, late) for person in people]


def lagging(verdict: Verdict, lag: float) -> Result:
    timing = Timing(evidence=4.0, lag=lag)
    return Result("04-light", verdict, (DARK,), timing, containment="contained")


def names(folder: Path) -> set[str]:
    return {path.name for path in folder.iterdir()} if folder.is_dir() else set()


def people(gradings: Iterable[Graded]) -> list[str]:
    return sorted(each.unit.person for each in gradings)
