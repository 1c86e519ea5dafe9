"""The process that checks for `watch`: `python -m course.watch.worker`.

Tasks come on standard input, a line each; what is said of them goes to standard output. It has loaded
everything before it gets its first task. Told to end, it ends a check in order, as Ctrl+C does, and itself.
"""

from __future__ import annotations

import contextlib
import importlib
import os
import signal
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from typing import NoReturn

from course.arena.sandbox.linux import PR_SET_PDEATHSIG, process_control
from course.content import open_course
from course.errors import CourseError
from course.grading.result import Result, Verdict
from course.home import CourseHome
from course.rosenv import cache_dir, find_ros
from course.watch.messages import message_to_line, task_from_line
from course.watch.model import Checked, Message, Said, Stuck, Task

_ENDINGS = (signal.SIGTERM, signal.SIGINT, signal.SIGHUP)


def main() -> int:
    for number in _ENDINGS:
        signal.signal(number, _call_off)
    process_control(PR_SET_PDEATHSIG, signal.SIGTERM)
    with contextlib.suppress(KeyboardInterrupt, BrokenPipeError), _Output() as output:
        importlib.import_module("course.grading.check")
        for line in sys.stdin:
            task = task_from_line(line)
            output.tell(checked(task, output.sayer(task.number)))
    return 0


def checked(task: Task, say: Callable[[str], None]) -> Message:
    """The check's result; whatever goes wrong is told of, too. KeyboardInterrupt passes through."""
    try:
        return Checked(task.number, _result(task, say))
    except CourseError as error:
        return Stuck(task.number, error.what, error.next_step or "")
    except Exception as error:  # noqa: BLE001 - shown and kept; the next save is checked all the same
        from course.grading.outcome import our_error

        return Checked(task.number, Result(task.exercise, Verdict.OUR_ERROR, fault=our_error(error)))


def _result(task: Task, say: Callable[[str], None]) -> Result:
    from course.grading.check import check_exercise
    from course.grading.load import runs_programs

    home = CourseHome(Path(task.home))
    exercise = open_course(Path(task.course), cache=cache_dir(os.environ) / "lessons").exercise(task.exercise)
    return check_exercise(
        exercise,
        home.path,
        ros=find_ros() if runs_programs(exercise) else None,
        on_progress=say,
        namespaces=task.namespaces,
        evidence=home.state / "evidence" / f"{exercise.id}.mcap",
        seed=home.seed() if exercise.questions or exercise.play else None,
    )


def _call_off(number: int, frame: object) -> NoReturn:
    for ending in _ENDINGS:
        signal.signal(ending, signal.SIG_IGN)  # nothing disturbs the tidying up
    raise KeyboardInterrupt


class _Output:
    """Standard output for messages alone: whatever else is printed here goes nowhere."""

    def __init__(self) -> None:
        self._one_at_a_time = threading.Lock()
        self._lines = os.fdopen(os.dup(sys.stdout.fileno()), "w", encoding="utf-8")
        with open(os.devnull, "w") as nowhere:  # noqa: PTH123 - a device
            os.dup2(nowhere.fileno(), sys.stdout.fileno())

    def __enter__(self) -> _Output:
        return self

    def __exit__(self, *_: object) -> None:
        with contextlib.suppress(BrokenPipeError):
            self._lines.close()

    def tell(self, message: Message) -> None:
        with self._one_at_a_time:
            self._lines.write(message_to_line(message) + "\n")
            self._lines.flush()

    def sayer(self, number: int) -> Callable[[str], None]:
        """For what is being done in check `number`; called from several threads."""
        return lambda text: self.tell(Said(number, text))


if __name__ == "__main__":
    raise SystemExit(main())
