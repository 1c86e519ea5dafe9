"""A process that grades: `python -m course.batch.worker DESCRIPTOR`; see `answering`."""

from __future__ import annotations

import contextlib
import time
from pathlib import Path

from course.batch.answering import answer_tasks
from course.batch.model import Graded, Task, graded_to_line, task_from_line
from course.batch.one import grade
from course.grading.rejudge import Beside


def main() -> int:
    with contextlib.closing(Beside()) as beside:
        answer_tasks(lambda line: graded_to_line(_timed(task_from_line(line), beside)))
    return 0


def _timed(task: Task, beside: Beside) -> Graded:
    began = time.monotonic()
    result = grade(task, Path(task.home), beside.judge)
    return Graded(task.unit, result, round(time.monotonic() - began, 3))


if __name__ == "__main__":
    raise SystemExit(main())
