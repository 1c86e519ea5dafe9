"""Mutants in, what became of them out: the parent's side of a court."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import tempfile
from collections.abc import Generator, Iterator, Sequence
from typing import TextIO

from course.content import Course, Exercise
from course.errors import OurFault
from course.grading.rejudge.process import start_judging
from course.validate.mutation.cases import Case, Mutated, Witness, answer_from_line, case_to_line
from course.validate.mutation.model import Judged, Mutant
from course.validate.mutation.recordings import Recorded

_COURT = "course.validate.mutation.court"
# Nearly all need a tenth of a second.
SECONDS = 10.0
_LOG = 2000
_CHUNK = 1 << 16


def judged(
    course: Course,
    exercise: Exercise,
    mutants: Sequence[Mutant],
    recorded: Sequence[Recorded],
    jobs: int,
    seconds: float = SECONDS,
) -> Generator[Judged | tuple[str, ...], None, None]:
    """First which proofs do not hold with the grader as it is; then each mutant, in no particular order.

    mutants: at least one. seconds: of a CPU, that a mutant may use. To stop early, close the iterator: all
    processes end. Raises OurFault when nothing can be judged.
    """
    with tempfile.TemporaryDirectory(prefix="ros2course-mutants-") as folder:
        case = Case(
            course=str(course.root),
            exercise=exercise.id,
            folder=folder,
            text=mutants[0].text.decode(),
            witnesses=tuple(Witness(one.proof, str(one.file), str(one.result)) for one in recorded),
            mutants=tuple(_mutated(mutant) for mutant in mutants),
            jobs=jobs,
            seconds=seconds,
        )
        for line in _answers(case):
            heard = answer_from_line(line)
            yield heard if isinstance(heard, tuple) else Judged(mutants[heard.index], heard.fate, heard.by)


def _mutated(mutant: Mutant) -> Mutated:
    change = mutant.change
    return Mutated(change.start, change.end, change.new.decode(), mutant.checks)


def _answers(case: Case) -> Iterator[str]:
    with contextlib.ExitStack() as stack:
        log = stack.enter_context(tempfile.TemporaryFile("w+", errors="replace"))
        reading, writing = os.pipe()
        answers = stack.enter_context(os.fdopen(reading, encoding="utf-8"))
        try:
            court = stack.enter_context(start_judging(_COURT, writing, log.fileno()))
        finally:
            os.close(writing)
        stack.callback(_end, court, answers)
        assert court.stdin is not None
        with contextlib.suppress(BrokenPipeError), court.stdin:
            court.stdin.write(case_to_line(case) + "\n")
        count = 0
        for line in answers:
            count += 1
            yield line
        if court.wait() != 0 or count != len(case.mutants) + 1:
            log.seek(0)
            raise OurFault(f"mutants of {case.exercise} cannot be judged: {log.read()[-_LOG:].strip()}")


def _end(court: subprocess.Popen[str], answers: TextIO) -> None:
    """It, and the mutants' processes: none of them writes a file any more."""
    if court.poll() is None:
        os.killpg(court.pid, signal.SIGKILL)  # it leads a group of its own
    while answers.read(_CHUNK):  # all of them hold the other end
        pass
