"""Stands in for course.validate.worker: does three proofs, and is busy with the fourth until it is ended."""

from __future__ import annotations

import os
import sys
import threading

from course.validate.tasks import proven_to_line, task_from_line
from course.validate.worker import Prover

PROOFS = 3

if __name__ == "__main__":
    prover = Prover()
    with os.fdopen(int(sys.argv[1]), "w") as answers:
        for done, line in enumerate(sys.stdin):
            if done == PROOFS:
                threading.Event().wait(60)
            answers.write(proven_to_line(prover.run(task_from_line(line))) + "\n")
            answers.flush()
