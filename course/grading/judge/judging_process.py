"""A process that judges recordings: `python -m course.grading.judge.judging_process DESCRIPTOR`.

Each line on standard input is a portion; each of its recordings gets one line on the descriptor, in order.
Recordings contain learners' texts, and parsing them may never end, or may crash the process.
Then the kernel ends it, and its parent knows which recording was the cause.
"""

from __future__ import annotations

import os
import resource
import signal
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import BinaryIO

from course.child import end_with_parent
from course.errors import OurFault, StorageError
from course.evidence.mcap_file import BadRecording, OtherFormat, load
from course.evidence.recording import Recording
from course.grading.judge.plugin import judge
from course.grading.protocol import (
    MOST_TIME,
    PORTION,
    Judged,
    Judgment,
    Portion,
    ScenarioState,
    Unjudged,
    UnjudgedCause,
)
from course.grading.scenario_digest import scenario_digest
from course.model import codec

_MOST_MEMORY = 1 << 30


def main() -> int:
    _, hard = resource.getrlimit(resource.RLIMIT_DATA)
    most = _MOST_MEMORY if hard == resource.RLIM_INFINITY else min(_MOST_MEMORY, hard)
    resource.setrlimit(resource.RLIMIT_DATA, (most, hard))
    end_with_parent()  # even in the middle of a recording
    signal.signal(signal.SIGALRM, signal.SIG_DFL)  # a Python handler would wait for a regular expression
    with os.fdopen(int(sys.argv[1]), "wb") as answers:
        answers.write(b"ready\n")
        answers.flush()
        portions = _Portions(sys.stdin.buffer)
        while (portion := portions.take()) is not None:
            _Work(portion, portions, answers).do()
    return 0


class _Portions:
    """The portions on standard input, read as they arrive."""

    def __init__(self, lines: BinaryIO) -> None:
        self._lines = lines
        self._next: Portion | None = None

    def take(self) -> Portion | None:
        """The next portion; None if there are no more."""
        portion, self._next = self._next, None
        if portion is None and (line := self._lines.readline()):
            portion = codec.from_json(line, Portion, "this line")
        return portion

    def take_like(self, other: Portion) -> Portion | None:
        """The next portion, if its checks are already collected; otherwise, it is kept for `take`."""
        portion = self.take()
        if portion and (portion.grader, portion.looks_at) == (other.grader, other.looks_at):
            return portion
        self._next = portion
        return None


class _Work:
    """A portion, and any following ones with the same checks: pytest collects once for all of them."""

    def __init__(self, portion: Portion, following: _Portions, answers: BinaryIO) -> None:
        self._portion = portion
        self._following: _Portions | None = following
        self._answers = answers
        self._asked = 0
        self._answered = 0
        self._scenario = ScenarioState.UNKNOWN
        self._digest = cache(self._digest_of)

    def do(self) -> None:
        signal.alarm(MOST_TIME)
        portion = self._portion
        judge(Path(portion.grader), portion.looks_at.keys(), self._recordings(), self._judged, self._stop)
        if self._answered != self._asked:  # pytest has swallowed an error, and our parent waits
            raise OurFault("not every recording was judged")
        signal.alarm(0)

    def _stop(self) -> None:
        """pytest has ended, perhaps early. Later portions get a new session."""
        self._following = None

    def _recordings(self) -> Iterator[Recording]:
        portion: Portion | None = self._portion
        while portion:
            self._asked += len(portion.files)
            yield from self._recordings_of(portion)
            portion = self._one_more()

    def _one_more(self) -> Portion | None:
        if self._following is None or self._asked >= PORTION:
            return None
        signal.alarm(0)  # there may be nothing to do for a long time
        portion = self._following.take_like(self._portion)
        signal.alarm(MOST_TIME)
        return portion

    def _recordings_of(self, portion: Portion) -> Iterator[Recording]:
        for exercise, file in portion.files:
            found = _read(Path(file), exercise)
            if isinstance(found, Unjudged):
                self._answer(found)
            else:
                self._scenario = self._compared(found)
                yield found

    def _judged(self, judgment: Judgment) -> None:
        self._answer(Judged(judgment, self._scenario))

    def _answer(self, answer: Judged | Unjudged) -> None:
        signal.alarm(0)  # the reader may take as long as it likes
        self._answers.write(codec.to_json(answer) + b"\n")
        self._answers.flush()
        self._answered += 1
        signal.alarm(MOST_TIME)

    def _compared(self, recording: Recording) -> ScenarioState:
        now = self._digest(recording.exercise)
        if not now or not recording.scenario:
            return ScenarioState.UNKNOWN
        return ScenarioState.SAME if now == recording.scenario else ScenarioState.CHANGED

    def _digest_of(self, exercise: str) -> str:
        return scenario_digest(Path(self._portion.grader), exercise, self._portion.looks_at[exercise])


def _read(file: Path, exercise: str) -> Recording | Unjudged:
    try:
        recording = load(file)
    except StorageError as error:
        if not file.exists():
            return Unjudged(UnjudgedCause.MISSING, "The recording no longer exists.")
        return Unjudged(UnjudgedCause.DAMAGED, f"The recording cannot be read: {_why(error)}.")
    except OtherFormat as error:
        what = f"The recording was made by another version of the course ({_why(error)})."
        return Unjudged(UnjudgedCause.FORMAT, what)
    except (BadRecording, MemoryError) as error:
        return Unjudged(UnjudgedCause.DAMAGED, f"The recording is damaged ({_why(error)}).")
    if recording.exercise != exercise:
        what = f"The recording is of {recording.exercise!r}, not of {exercise}."
        return Unjudged(UnjudgedCause.EXERCISE, what)
    return recording


def _why(error: BaseException) -> str:
    """The library's message behind the error, which may quote the file."""
    cause = error.__cause__ or error
    text = cause.strerror if isinstance(cause, OSError) else str(cause)
    return ascii(text or type(cause).__name__)[1:-1][:120]


if __name__ == "__main__":
    raise SystemExit(main())
