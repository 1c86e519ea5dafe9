"""Runs proofs in worker processes, and does not blame graders for failures on a busy machine."""

from __future__ import annotations

import contextlib
import tempfile
from collections import deque
from collections.abc import Generator, Iterator, Mapping, Sequence
from pathlib import Path

from course.batch.pool import Pool
from course.content import Exercise
from course.files import wipe
from course.grading.attempts import ATTEMPTS
from course.home.storage import storing
from course.model import replace
from course.validate.claims import Claims
from course.validate.proofs import PROOFS, Proof, ProofResult, ProofTask


def run(
    root: Path,
    exercises: Sequence[Exercise],
    proofs: Sequence[Proof],
    jobs: int,
    turns: int = 1,
    evidence: Mapping[Proof, Path] | None = None,
) -> Generator[ProofResult, None, None]:
    """The result of each proof in each turn, from its last attempt, as soon as it is known.

    root: of the course. evidence: files in which to keep recordings.
    When the iteration ends, for whatever reason, the gradings are ended in order.
    """
    with storing("there is no room for what is graded"):
        folder = Path(tempfile.mkdtemp(prefix="ros2course-validate-"))
    try:
        kept = {proof: str(file) for proof, file in (evidence or {}).items()}
        tasks = [
            ProofTask(proof, turn + 1, str(root), str(folder), evidence=kept.get(proof))
            for turn in range(turns)
            for proof in proofs
        ]
        yield from _Schedule(Claims(exercises), tasks).proven(jobs)
    finally:
        wipe(folder)


class _Schedule:
    """First all proofs, several at once; then those whose results were doubtful."""

    def __init__(self, claims: Claims, tasks: Sequence[ProofTask]) -> None:
        self._claims = claims
        self._waiting = deque(tasks)
        self._sent: dict[tuple[Proof, int], ProofTask] = {}
        self._doubtful: list[tuple[ProofTask, ProofResult]] = []

    def proven(self, jobs: int) -> Iterator[ProofResult]:
        # The second attempt runs with fewer others at the same time, and the third one alone.
        for at_once in (jobs, max(1, jobs // ATTEMPTS), 1):
            # Starting a worker costs as much as a proof, so each worker gets at least two.
            yield from self._round(min(at_once, -(-len(self._waiting) // 2)))
            yield from self._certain()

    def _certain(self) -> Iterator[ProofResult]:
        """Results that were doubtful in a round and are certain after it. The others wait for the next."""
        doubtful, self._doubtful = self._doubtful, []
        for task, proven in doubtful:
            if self._claims.deserves_another(proven):
                self._waiting.append(replace(task, attempt=task.attempt + 1))
            else:
                yield proven

    def _round(self, at_once: int) -> Iterator[ProofResult]:
        with contextlib.closing(Pool(PROOFS, at_once, self._next).results()) as results:
            for proven in results:
                task = self._sent.pop((proven.proof, proven.turn))
                if self._claims.deserves_another(proven):
                    self._doubtful.append((task, proven))
                else:
                    yield proven

    def _next(self) -> ProofTask | None:
        if not self._waiting:
            return None
        task = self._waiting.popleft()
        self._sent[task.proof, task.turn] = task
        return task
