"""A process that grades: `python -m course.batch.worker DESCRIPTOR`; see `course.child`.

Any failure is a result like any other.
"""

from __future__ import annotations

import contextlib
import os
import time
from pathlib import Path

from course.arena.mystery_module import seed_of_submission
from course.batch.gradings import Graded, GradingTask
from course.child import answer_tasks
from course.content import open_course
from course.errors import CourseError
from course.grading.attempts import concluded
from course.grading.check import Helpers, Progress, Request, attempt_exercise, solution_passes
from course.grading.load import runs_programs
from course.grading.outcomes import our_error
from course.home.course_home import is_home, read_marker
from course.model import replace
from course.model.feedback import Feedback
from course.model.result import Result, Verdict
from course.rosenv import cache_dir, find_ros


def grade(task: GradingTask, home: Path, helpers: Helpers, say: Progress = lambda text: None) -> Result:
    """The result of this attempt; after the last attempt, the one that counts."""
    try:
        request = replace(_request(task, home), on_progress=say)
        result = attempt_exercise(request, helpers)
        result = concluded(
            result, task.unit.attempt, request.exercise, lambda: solution_passes(request, helpers)
        )
    except CourseError as error:
        return _fault(task, Feedback(summary=error.what, advice=error.next_step))
    except Exception as error:  # noqa: BLE001 - kept and shown; the others of the batch go on
        return _fault(task, our_error(error))
    if task.contained and result.containment not in ("contained", ""):
        # It has been run, but must not count. (`grade` checks this before it starts the first one.)
        return _fault(task, Feedback(summary=f"It was not contained: {'; '.join(result.notes)}."))
    return result


def _request(task: GradingTask, home: Path) -> Request:
    course = open_course(Path(task.course) if task.course else None, cache=cache_dir(os.environ) / "lessons")
    exercise = course.exercise(task.unit.exercise)
    return Request(
        exercise,
        home,
        ros=find_ros() if runs_programs(exercise) else None,
        evidence=Path(task.evidence),
        local=False,
        seed=seed_of(task.unit.person, home),
    )


def seed_of(person: str, home: Path) -> int:
    """The learner's own if their course home was handed in, because their answers depend on it."""
    if is_home(home):
        try:
            return read_marker(home)
        except CourseError:  # they may have changed it
            pass
    return seed_of_submission(person)


def _fault(task: GradingTask, fault: Feedback) -> Result:
    return Result(task.unit.exercise, Verdict.OUR_ERROR, fault=fault)


def main() -> int:
    with contextlib.closing(Helpers()) as helpers:
        answer_tasks(GradingTask, lambda task, tell: _timed(task, helpers, tell))
    return 0


def _timed(task: GradingTask, helpers: Helpers, say: Progress) -> Graded:
    began = time.monotonic()
    result = grade(task, Path(task.home), helpers, say)
    return Graded(task.unit, result, round(time.monotonic() - began, 3))


if __name__ == "__main__":
    raise SystemExit(main())
