"""Grades one task, here and now. Whatever goes wrong is a result like any other."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

from course.arena.play_module import seed_of_submission
from course.batch.model import Task
from course.content import open_course
from course.errors import CourseError
from course.feedback import Feedback
from course.grading.check import Judge, check_exercise
from course.grading.disturbed import is_doubtful
from course.grading.load import runs_programs
from course.grading.outcome import our_error
from course.grading.result import Result, Verdict
from course.home.model import is_home, read_marker
from course.rosenv import cache_dir, find_ros


def grade(task: Task, home: Path, judge: Judge | None = None) -> Result:
    """The verdict, never believing that a loaded machine, or a fault of ours, is the learner's.

    judge: who judges what is recorded; None for the grading process itself.
    """
    try:
        result = _checked(task, home, judge)
    except CourseError as error:
        return _fault(task, Feedback(summary=error.what, advice=error.next_step))
    except Exception as error:  # noqa: BLE001 - kept and shown; the others of the batch go on
        return _fault(task, our_error(error))
    if task.contained and result.containment not in ("contained", ""):
        # Nothing of it may count, but it has been run: `grade` looks before it starts the first one.
        return _fault(task, Feedback(summary=f"It was not contained: {'; '.join(result.notes)}."))
    return _too_loaded(result) if is_doubtful(result) else result


def _checked(task: Task, home: Path, judge: Judge | None) -> Result:
    course = open_course(Path(task.course) if task.course else None, cache=cache_dir(os.environ) / "lessons")
    exercise = course.exercise(task.unit.exercise)
    return check_exercise(
        exercise,
        home,
        ros=find_ros() if runs_programs(exercise) else None,
        evidence=Path(task.evidence),
        local=False,
        seed=seed_of(task.unit.person, home),
        namespaces=True,
        judge=judge,
    )


def seed_of(person: str, home: Path) -> int:
    """The learner's own, if their course home came along: their answers belong to it."""
    if is_home(home):
        try:
            return read_marker(home)
        except CourseError:  # whatever they made of it
            pass
    return seed_of_submission(person)


def _too_loaded(result: Result) -> Result:
    lag = result.timing.lag
    fault = Feedback(
        summary=f"This machine was too busy to judge: the recorder had to wait {lag:.2f} s for a processor.",
        advice="Grade it again with less beside it: --jobs 1.",
    )
    return replace(result, verdict=Verdict.OUR_ERROR, fault=fault)


def _fault(task: Task, fault: Feedback) -> Result:
    return Result(task.unit.exercise, Verdict.OUR_ERROR, fault=fault)
