"""A process that judges recordings: `python -m course.grading.rejudge.worker DESCRIPTOR`.

Each line on standard input is a portion; each recording of it gets one line on the descriptor, in order.
Learners' texts are in the recordings, and what parses them may never come to an end, or bring down the
process: then the kernel ends it, and its parent knows by which recording.
"""

from __future__ import annotations

import os
import resource
import signal
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import TextIO

from course.errors import OurFault, StorageError
from course.evidence.mcap_file import BadRecording, OtherFormat, load
from course.evidence.recording import Recording
from course.grading.channel import Judgement
from course.grading.judging import judge
from course.grading.rejudge.model import (
    MOST_TIME,
    READY,
    Portion,
    Problem,
    Rejudged,
    Scenario,
    Trouble,
    answer_to_line,
    portion_from_line,
)
from course.grading.scenario_digest import scenario_digest

_MOST_MEMORY = 1 << 30


def main() -> int:
    _, hard = resource.getrlimit(resource.RLIMIT_DATA)
    most = _MOST_MEMORY if hard == resource.RLIM_INFINITY else min(_MOST_MEMORY, hard)
    resource.setrlimit(resource.RLIMIT_DATA, (most, hard))
    signal.signal(signal.SIGALRM, signal.SIG_DFL)  # no handler: Python's would wait for a regular expression
    with os.fdopen(int(sys.argv[1]), "w", buffering=1, encoding="utf-8") as answers:
        answers.write(READY + "\n")
        for line in sys.stdin:
            _Work(portion_from_line(line), answers).do()
    return 0


class _Work:
    """One portion."""

    def __init__(self, portion: Portion, answers: TextIO) -> None:
        self._portion = portion
        self._answers = answers
        self._answered = 0
        self._scenario = Scenario.UNKNOWN
        self._digest = cache(self._digest_of)

    def do(self) -> None:
        signal.alarm(MOST_TIME)
        portion = self._portion
        judge(Path(portion.grader), portion.looks_at.keys(), self._recordings(), self._judged)
        if self._answered != len(portion.files):  # pytest has swallowed what went wrong; our parent waits
            raise OurFault("not every recording was judged")
        signal.alarm(0)

    def _recordings(self) -> Iterator[Recording]:
        for exercise, file in self._portion.files:
            found = _read(Path(file), exercise)
            if isinstance(found, Problem):
                self._answer(found)
            else:
                self._scenario = self._compared(found)
                yield found

    def _judged(self, judgement: Judgement) -> None:
        self._answer(Rejudged(judgement, self._scenario))

    def _answer(self, answer: Rejudged | Problem) -> None:
        signal.alarm(0)  # who reads may take as long as they like
        self._answers.write(answer_to_line(answer) + "\n")
        self._answered += 1
        signal.alarm(MOST_TIME)

    def _compared(self, recording: Recording) -> Scenario:
        now = self._digest(recording.exercise)
        if not now or not recording.scenario:
            return Scenario.UNKNOWN
        return Scenario.SAME if now == recording.scenario else Scenario.CHANGED

    def _digest_of(self, exercise: str) -> str:
        return scenario_digest(Path(self._portion.grader), exercise, self._portion.looks_at[exercise])


def _read(file: Path, exercise: str) -> Recording | Problem:
    try:
        recording = load(file)
    except StorageError as error:
        if not file.exists():
            return Problem(Trouble.MISSING, "The recording is not there any more.")
        return Problem(Trouble.DAMAGED, f"The recording cannot be read: {_why(error)}.")
    except OtherFormat as error:
        return Problem(Trouble.FORMAT, f"Another version of the course made the recording ({_why(error)}).")
    except (BadRecording, MemoryError) as error:
        return Problem(Trouble.DAMAGED, f"The recording is damaged ({_why(error)}).")
    if recording.exercise != exercise:
        return Problem(Trouble.EXERCISE, f"The recording is of {recording.exercise!r}, not of {exercise}.")
    return recording


def _why(error: BaseException) -> str:
    """What the libraries found, which the error was raised from; it may quote the file."""
    cause = error.__cause__ or error
    text = cause.strerror if isinstance(cause, OSError) else str(cause)
    return ascii(text or type(cause).__name__)[1:-1][:120]


if __name__ == "__main__":
    raise SystemExit(main())
