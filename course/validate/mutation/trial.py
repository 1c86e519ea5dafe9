"""Mutants in, what became of them out: the parent's side of a court."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import tempfile
from collections.abc import Generator, Iterator, Sequence
from pathlib import Path
from typing import TextIO

import course as package
from course.content import Course, Exercise
from course.errors import OurFault
from course.validate.mutation.cases import Case, Mutated, Witness, answer_from_line, case_to_line
from course.validate.mutation.model import Judged, Mutant
from course.validate.mutation.recordings import Recorded

_COURT = "course.validate.mutation.court"
# Nearly all need a tenth of a second.
SECONDS = 10.0
_LOG = 2000
_CHUNK = 1 << 16
# No preparation for ROS by the wheels, which judging does not need; no plugins but ours.
_QUICK = {"_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1", "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}


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
            court = stack.enter_context(_start(writing, log.fileno()))
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


def _start(answers: int, log: int) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-m", _COURT, str(answers)],
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        stderr=log,
        env=_environment(),
        cwd="/",
        pass_fds=(answers,),
        start_new_session=True,  # Ctrl+C at the terminal is for us
        text=True,
    )


def _environment() -> dict[str, str]:
    """Ours, but nothing of it tells pytest what to do."""
    own = str(Path(package.__file__).parents[1])
    path = os.pathsep.join(part for part in (own, os.environ.get("PYTHONPATH")) if part)
    others = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST_")}
    return {**others, **_QUICK, "PYTHONPATH": path}
