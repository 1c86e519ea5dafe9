"""A process that runs proofs: `python -m course.validate.worker DESCRIPTOR`; see `batch.answering`."""

from __future__ import annotations

import contextlib
import os
import tempfile
import time
from pathlib import Path

from course.batch.answering import answer_tasks
from course.content import Course, Exercise, open_course
from course.errors import CourseError, MissingHere
from course.feedback import Feedback
from course.grading import trial
from course.grading.check import check_exercise
from course.grading.load import runs_programs
from course.grading.outcome import our_error
from course.grading.rejudge import Beside
from course.grading.result import Result, Verdict
from course.grading.trial_answers import SEED
from course.rosenv import cache_dir, find_ros
from course.rosenv.files import wipe
from course.validate.plan import Kind, Proof
from course.validate.tasks import Proven, Task, proven_to_line, task_from_line


def main() -> int:
    with contextlib.closing(Prover()) as prover:
        answer_tasks(lambda line: proven_to_line(prover.run(task_from_line(line))))
    return 0


class Prover:
    """Keeps what several proofs need: the course as it was read, and a process that judges recordings."""

    def __init__(self) -> None:
        self._course: Course | None = None
        self._beside = Beside()

    def close(self) -> None:
        self._beside.close()

    def run(self, task: Task) -> Proven:
        """Whatever goes wrong is a result like any other."""
        began = time.monotonic()
        folder = Path(tempfile.mkdtemp(dir=task.folder))
        try:
            laid, result = self._graded(task, folder)
        finally:
            wipe(folder)
        seconds = round(time.monotonic() - began, 3)
        return Proven(task.proof, task.turn, task.attempt, result, seconds, laid)

    def _graded(self, task: Task, folder: Path) -> tuple[bool, Result]:
        laid = False
        home = folder / "home"
        home.mkdir()
        try:
            course = self._opened(task.course)
            exercise = course.exercise(task.proof.exercise)
            lay(course, exercise, task.proof, home)
            laid = True
            return laid, self._checked(exercise, home, Path(task.evidence or folder / "recording.mcap"))
        except MissingHere as error:
            return laid, _without_verdict(task, Verdict.NOT_AVAILABLE, _told(error))
        except CourseError as error:
            return laid, _without_verdict(task, Verdict.OUR_ERROR, _told(error))
        except Exception as error:  # noqa: BLE001 - an author's code may do anything: it is told as it is
            return laid, _without_verdict(task, Verdict.OUR_ERROR, our_error(error))

    def _opened(self, root: str) -> Course:
        if self._course is None or str(self._course.root) != root:
            self._course = open_course(Path(root), cache=cache_dir(os.environ) / "lessons")
        return self._course

    def _checked(self, exercise: Exercise, home: Path, evidence: Path) -> Result:
        return check_exercise(
            exercise,
            home,
            ros=find_ros() if runs_programs(exercise) else None,
            evidence=evidence,
            seed=SEED,
            judge=self._beside.judge,
        )


def lay(course: Course, exercise: Exercise, proof: Proof, home: Path) -> None:
    """What the proof grades, into the empty folder `home`. Raises CourseError when that is not possible."""
    if proof.kind is Kind.SOLUTION:
        trial.lay_solution(course, exercise, home)
    elif proof.kind is Kind.STARTER:
        trial.lay_starter(course, exercise, home)
    elif proof.kind is Kind.MISTAKE:
        mistake = next(mistake for mistake in exercise.mistakes() if mistake.id == proof.name)
        trial.lay_mistake(course, exercise, mistake, home)
    else:
        other = next(other for other in exercise.alternatives() if other.name == proof.name)
        trial.lay_alternative(course, exercise, other, home)


def _without_verdict(task: Task, verdict: Verdict, fault: Feedback) -> Result:
    return Result(task.proof.exercise, verdict, fault=fault)


def _told(error: CourseError) -> Feedback:
    return Feedback(summary=error.what, advice=error.next_step)


if __name__ == "__main__":
    raise SystemExit(main())
