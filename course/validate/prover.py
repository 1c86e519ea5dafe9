"""A process that runs proofs: `python -m course.validate.prover DESCRIPTOR`; see `course.child`."""

from __future__ import annotations

import contextlib
import os
import tempfile
import time
from collections.abc import Callable, Iterable
from pathlib import Path

from course.child import answer_tasks
from course.content import Course, Exercise, Mistake, open_course
from course.content.mistakes import load_mistakes
from course.errors import CourseError, MissingHere
from course.files import wipe
from course.grading import trial
from course.grading.check import Helpers, Request, attempt_exercise
from course.grading.load import runs_programs
from course.grading.outcomes import our_error
from course.grading.quiz.judge import failed
from course.grading.quiz.program import printed, wrong_about
from course.grading.trial_answers import SEED
from course.model import replace
from course.model.feedback import Feedback
from course.model.result import Result, Verdict, verdict_of
from course.rosenv import Ros, cache_dir, find_ros
from course.validate import leads
from course.validate.claims import words_of
from course.validate.proofs import Proof, ProofKind, ProofResult, ProofTask


def main() -> int:
    with contextlib.closing(Prover()) as prover:
        answer_tasks(ProofTask, lambda task, _: prover.run(task))
    return 0


class Prover:
    """Keeps what several proofs need: the course, its mistakes, the ROS, and our helper processes."""

    def __init__(self) -> None:
        self._course: Course | None = None
        self._ros: Ros | None = None
        self._mistakes: dict[Path, tuple[Mistake, ...]] = {}
        self._helpers = Helpers()

    def close(self) -> None:
        self._helpers.close()

    def run(self, task: ProofTask) -> ProofResult:
        """Grade it. Errors become results, too."""
        began = time.monotonic()
        folder = Path(tempfile.mkdtemp(dir=task.folder))
        try:
            laid, result, misled = self._graded(task, folder)
        finally:
            wipe(folder)
        seconds = round(time.monotonic() - began, 3)
        return ProofResult(task.proof, task.turn, task.attempt, result, seconds, laid, misled)

    def _graded(self, task: ProofTask, folder: Path) -> tuple[bool, Result, str | None]:
        laid = False
        home = folder / "home"
        home.mkdir()
        try:
            course = self._opened(task.course)
            exercise = course.exercise(task.proof.exercise)
            before = lay(course, exercise, task.proof, home, self._mistakes_of)
            laid = True
            evidence = Path(task.evidence or folder / "recording.mcap")
            mistake = self._mistake(exercise, task.proof)
            result = self._checked(exercise, home, evidence, mistake.says if mistake else ())
            if task.proof.kind is ProofKind.SOLUTION:
                result = _predicted(exercise, result)
            return laid, result, leads.misled(result, mistake, before, home) if mistake else None
        except MissingHere as error:
            return laid, _without_verdict(task, Verdict.NOT_AVAILABLE, _told(error)), None
        except CourseError as error:
            return laid, _without_verdict(task, Verdict.OUR_ERROR, _told(error)), None
        except Exception as error:  # noqa: BLE001 - an author's code may raise anything, which is reported
            return laid, _without_verdict(task, Verdict.OUR_ERROR, our_error(error)), None

    def _opened(self, root: str) -> Course:
        if self._course is None or str(self._course.root) != root:
            self._course = open_course(Path(root), cache=cache_dir(os.environ) / "lessons")
        return self._course

    def _checked(self, exercise: Exercise, home: Path, evidence: Path, says: tuple[str, ...]) -> Result:
        ros = self._found_ros() if runs_programs(exercise) else None

        def looks_for_cause(result: Result) -> bool:
            """Only if a mistake claims words that the feedback does not contain without the cause."""
            said = "\n".join(words_of(check.feedback) for check in result.checks)
            return any(words not in said for words in says)

        request = Request(
            exercise, home, ros=ros, evidence=evidence, seed=SEED, looks_for_cause=looks_for_cause
        )
        return attempt_exercise(request, self._helpers)

    def _mistake(self, exercise: Exercise, proof: Proof) -> Mistake | None:
        if proof.kind is not ProofKind.MISTAKE:
            return None
        return next(one for one in self._mistakes_of(exercise) if one.id == proof.name)

    def _mistakes_of(self, exercise: Exercise) -> Iterable[Mistake]:
        if exercise.folder not in self._mistakes:
            self._mistakes[exercise.folder] = load_mistakes(exercise.folder)
        return (one for one in self._mistakes[exercise.folder] if one.exercise == exercise.id)

    def _found_ros(self) -> Ros:
        self._ros = self._ros or find_ros()
        return self._ros


def lay(
    course: Course,
    exercise: Exercise,
    proof: Proof,
    home: Path,
    mistakes_of: Callable[[Exercise], Iterable[Mistake]] = Exercise.mistakes,
) -> dict[str, str]:
    """Put the files that the proof grades into the empty folder `home`. Raises CourseError if that fails.

    Returns what files contained before a mistake was made in them.
    """
    if proof.kind is ProofKind.SOLUTION:
        trial.lay_solution(course, exercise, home)
    elif proof.kind is ProofKind.STARTER:
        trial.lay_starter(course, exercise, home)
    elif proof.kind is ProofKind.MISTAKE:
        mistake = next(mistake for mistake in mistakes_of(exercise) if mistake.id == proof.name)
        return trial.lay_mistake(course, exercise, mistake, home)
    else:
        other = next(other for other in exercise.alternatives() if other.name == proof.name)
        trial.lay_alternative(course, exercise, other, home)
    return {}


def _predicted(exercise: Exercise, result: Result) -> Result:
    """Fail each question whose program prints something other than the right choice says."""
    found = {}
    for question in exercise.questions:
        if question.program and (said := wrong_about(question, printed(question.program, find_ros()))):
            found[question.id] = failed(question, Feedback(summary=said))
    checks = tuple(found.get(check.id, check) for check in result.checks)
    return replace(result, checks=checks, verdict=verdict_of(checks)) if found else result


def _without_verdict(task: ProofTask, verdict: Verdict, fault: Feedback) -> Result:
    return Result(task.proof.exercise, verdict, fault=fault)


def _told(error: CourseError) -> Feedback:
    return Feedback(summary=f"{error.what.removesuffix('.')}.", advice=error.next_step)


if __name__ == "__main__":
    raise SystemExit(main())
