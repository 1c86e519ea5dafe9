"""The process that checks for `watch`: `python -m course.watch.check_worker DESCRIPTOR`; see `course.child`.

It loads everything before its first task. When it is told to end, it ends the check in order, as for Ctrl+C.
"""

from __future__ import annotations

import contextlib
import importlib
import os
import signal
from pathlib import Path

from course.child import Tell, answer_tasks
from course.content import open_course
from course.errors import CourseError
from course.grading.supervisor import ForkServer
from course.home import CourseHome
from course.model.result import Result, Verdict
from course.rosenv import cache_dir, find_ros
from course.watch.updates import Checked, CheckTask, Message, Said, SoFar, Stuck


def main() -> int:
    with contextlib.closing(ForkServer()) as fork_server:
        fork_server.start_early()
        importlib.import_module("course.grading.check")
        answer_tasks(
            CheckTask, lambda task, tell: checked(task, tell, fork_server), at_parents_end=signal.SIGTERM
        )
    return 0


def checked(task: CheckTask, tell: Tell, fork_server: ForkServer) -> Message:
    """The check's result, or a message about what went wrong. KeyboardInterrupt passes through."""
    try:
        return Checked(task.number, _result(task, tell, fork_server))
    except CourseError as error:
        return Stuck(task.number, error.what, error.next_step or "")
    except Exception as error:  # noqa: BLE001 - shown and stored; the next save is checked anyway
        from course.grading.outcomes import our_error

        return Checked(task.number, Result(task.exercise, Verdict.OUR_ERROR, fault=our_error(error)))


def _result(task: CheckTask, tell: Tell, fork_server: ForkServer) -> Result:
    from course.grading.check import Request, check_exercise
    from course.grading.load import runs_programs

    home = CourseHome(Path(task.home))
    exercise = open_course(Path(task.course), cache=cache_dir(os.environ) / "lessons").exercise(task.exercise)
    request = Request(
        exercise,
        home.path,
        ros=find_ros() if runs_programs(exercise) else None,
        on_progress=lambda text: tell(Said(task.number, text)),
        namespaces=task.namespaces,
        evidence=home.state / "evidence" / f"{exercise.id}.mcap",
        seed=home.seed() if exercise.questions or exercise.play else None,
        so_far=lambda result: tell(SoFar(task.number, result)),
    )
    return check_exercise(request, fork_server)


if __name__ == "__main__":
    raise SystemExit(main())
