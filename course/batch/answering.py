"""What every worker process does: one task after another, a line each, until its parent is gone.

Each task is a line on standard input, each answer a line on the descriptor that is the process's argument.
It ends with its parent, however that ends.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
from collections.abc import Callable

from course.arena.sandbox.linux import PR_SET_PDEATHSIG, process_control


def answer_tasks(answer: Callable[[str], str]) -> None:
    """answer: gets a task as its line, gives the answer as one. A signal to end ends it in order."""
    process_control(PR_SET_PDEATHSIG, signal.SIGKILL)
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    signal.signal(signal.SIGINT, signal.default_int_handler)
    with contextlib.suppress(KeyboardInterrupt), os.fdopen(int(sys.argv[1]), "w") as answers:
        for line in sys.stdin:
            answers.write(answer(line) + "\n")
            answers.flush()
