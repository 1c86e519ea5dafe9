"""A process that grades, one task after another: `python -m course.batch.worker`.

Each task is a line of JSON on standard input, each answer a line on the descriptor that is the argument.
It ends with its parent, however that ends, and all that it started ends with it.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
import time
from pathlib import Path

from course.arena.sandbox.linux import PR_SET_PDEATHSIG, process_control
from course.batch.model import Graded, Task, graded_to_line, task_from_line
from course.batch.one import grade
from course.grading.rejudge import Beside


def main() -> int:
    process_control(PR_SET_PDEATHSIG, signal.SIGKILL)
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    signal.signal(signal.SIGINT, signal.default_int_handler)
    with (
        contextlib.suppress(KeyboardInterrupt),
        os.fdopen(int(sys.argv[1]), "w") as answers,
        contextlib.closing(Beside()) as beside,
    ):
        for line in sys.stdin:
            answers.write(graded_to_line(_timed(task_from_line(line), beside)) + "\n")
            answers.flush()
    return 0


def _timed(task: Task, beside: Beside) -> Graded:
    began = time.monotonic()
    result = grade(task, Path(task.home), beside.judge)
    return Graded(task.unit, result, round(time.monotonic() - began, 3))


if __name__ == "__main__":
    raise SystemExit(main())
