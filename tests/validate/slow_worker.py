"""A fake course.validate.prover: does three proofs, and is busy with the fourth until it is ended."""

from __future__ import annotations

import threading
from itertools import count

from course.child import answer_tasks
from course.validate.proofs import ProofResult, ProofTask
from course.validate.prover import Prover

PROOFS = 3

if __name__ == "__main__":
    prover, asked = Prover(), count()

    def answer(task: ProofTask, _: object) -> ProofResult:
        if next(asked) == PROOFS:
            threading.Event().wait(60)
        return prover.run(task)

    answer_tasks(ProofTask, answer)
