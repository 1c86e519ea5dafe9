"""The parent's side of the processes that judge recordings: `Judge` for one at a time, `rejudge` for many.

A process takes portions of recordings whose checks are in one module, so that pytest collects only once. It
answers in order, so if it dies, the first recording without an answer is the cause. That one is not judged,
and another process takes the rest.
"""

from __future__ import annotations

import contextlib
import os
import selectors
import signal
import tempfile
from collections import deque
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import IO, Generic, TypeVar

from course.child import Child
from course.content import Exercise
from course.errors import OurFault
from course.grading.protocol import (
    MOST_TIME,
    PORTION,
    Judged,
    Judgment,
    Portion,
    Unjudged,
    UnjudgedCause,
    read_answer,
)
from course.model.feedback import Feedback
from course.model.result import Doubt

Key = TypeVar("Key")

_PROCESS = "course.grading.judge.judging_process"
_LOG = 2000
# The wheels do not prepare ROS, which takes longer than judging ten recordings. No plugins but ours.
_QUICK = {"_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1", "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}


@dataclass(frozen=True)
class StoredRecording(Generic[Key]):
    """A recording (MCAP) of an exercise. key: how the caller identifies it; the process never gets it."""

    key: Key
    exercise: Exercise
    file: Path


class JudgingProcess(Generic[Key]):
    """waiting: recordings that it has not answered yet. answers: the descriptor to wait on."""

    def __init__(self) -> None:
        self.waiting: deque[StoredRecording[Key]] = deque()
        self._ready = False
        with contextlib.ExitStack() as stack:
            self._log = stack.enter_context(tempfile.TemporaryFile("w+", errors="replace"))
            self._child = start_judging(_PROCESS, self._log)
            stack.callback(self._child.close)
            stack.callback(self._child.process.kill)
            self._stack = stack.pop_all()
        self.answers = self._child.answers

    def prepare(self, exercises: Iterable[Exercise]) -> None:
        """Announce exercises of one module, whose recordings are about to follow."""
        self._send(exercises, ())

    def take(self, recordings: list[StoredRecording[Key]], prepared: Iterable[Exercise] = ()) -> None:
        """Judge recordings whose checks are in one module. prepared: what `prepare` was given for it."""
        self.waiting.extend(recordings)
        own = {stored.exercise.id: stored.exercise for stored in recordings}
        self._send({**{one.id: one for one in prepared}, **own}.values(), recordings)

    def _send(self, exercises: Iterable[Exercise], recordings: Iterable[StoredRecording[Key]]) -> None:
        looks_at = {one.id: (*one.files, *one.looks_at) for one in exercises}
        files = tuple((stored.exercise.id, str(stored.file)) for stored in recordings)
        (grader,) = {str(one.grader) for one in exercises}
        self._child.tell(Portion(grader, looks_at, files))  # if it has ended, `read` tells

    def read(self) -> list[bytes] | None:
        """The new answers; None if the process has ended."""
        lines = self._child.read()
        if lines and not self._ready:
            self._ready = True
            del lines[0]
        return lines

    def how_it_ended(self) -> Unjudged:
        """The answer for the recording that ended the process. Raises OurFault if it never started."""
        code = self._child.process.wait()
        if not self._ready:
            self._log.seek(0)
            raise OurFault(f"recordings cannot be judged here: {self._log.read()[-_LOG:].strip()}")
        if code == -signal.SIGALRM:
            return Unjudged(UnjudgedCause.FATAL, f"Judging it took more than {MOST_TIME} s.")
        how = f"by signal {-code}" if code < 0 else f"with {code}"
        return Unjudged(UnjudgedCause.FATAL, f"The process that judged it was ended {how}.")

    def close(self) -> None:
        """End the process, if it is still running."""
        self._stack.close()


def start_judging(module: str, log: IO[str]) -> Child:
    """Run a module that judges recordings. Nothing in its environment tells pytest what to do."""
    others = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST_")}
    return Child(module, log=log, environment={**others, **_QUICK}, folder="/")


class Judge:
    """Judges one recording after another, in one process. Close it; it also ends with its owner."""

    def __init__(self) -> None:
        self._process: JudgingProcess[None] | None = None
        self._known: dict[str, Exercise] = {}

    def prepare(self, exercise: Exercise) -> None:
        """Optional: load what judging this exercise needs while its recording is still being made.

        Raises OurFault if no process can be started.
        """
        self._started().prepare(self._beside(exercise))

    def judge(self, exercise: Exercise, file: Path) -> Judgment:
        """What the checks say about the recording; with a fault if it could not be judged.

        Raises OurFault if no process can be started.
        """
        process = self._started()
        process.take([StoredRecording(None, exercise, file)], self._beside(exercise))
        while (lines := process.read()) == []:
            pass
        if lines is not None:
            answer = read_answer(lines[0])
            return _unjudged(answer) if isinstance(answer, Unjudged) else answer.judgment
        try:
            return _unjudged(process.how_it_ended())
        finally:
            self.close()  # the next recording gets another process

    def _started(self) -> JudgingProcess[None]:
        self._process = self._process or JudgingProcess()
        return self._process

    def _beside(self, exercise: Exercise) -> list[Exercise]:
        """All known exercises of its module, because pytest collects the checks once for all of them."""
        self._known[exercise.id] = exercise
        return [one for one in self._known.values() if one.grader == exercise.grader]

    def close(self) -> None:
        """End the process, if there is one."""
        process, self._process = self._process, None
        if process is not None:
            process.close()


def _unjudged(answer: Unjudged) -> Judgment:
    # A submission may cause a recording that no process can judge. Any other cause is our fault.
    theirs = answer.cause in (UnjudgedCause.FATAL, UnjudgedCause.DAMAGED)
    return Judgment((), Feedback(summary=answer.what), Doubt.SPOILT if theirs else None)


def rejudge(
    recordings: Iterable[StoredRecording[Key]], *, jobs: int | None = None
) -> Iterator[tuple[Key, Judged | Unjudged]]:
    """Judge each recording with the current checks of its exercise, in no particular order.

    jobs: processes at once; by default, as many as there are cores. An error in one recording does not
    affect the others; if a grader cannot be run, its judgments have a `fault`. Nothing is read before you
    ask for it, so a slow caller slows the processes down. To stop early, close the iterator. Questions are
    not judged here: see `regraded`. Raises OurFault if no process can be started.
    """
    portions = deque(_portions(recordings))
    most = min(jobs or len(os.sched_getaffinity(0)), len(portions))
    with contextlib.ExitStack() as stack:
        yield from _Crew(portions, stack).answers(most)


def _portions(recordings: Iterable[StoredRecording[Key]]) -> Iterator[list[StoredRecording[Key]]]:
    modules: dict[Path, list[StoredRecording[Key]]] = {}
    for stored in recordings:
        modules.setdefault(stored.exercise.grader, []).append(stored)
    for every in modules.values():
        rest = iter(every)
        while portion := list(islice(rest, PORTION)):
            yield portion


class _Crew(Generic[Key]):
    """Processes, each with its portion. stack: ends them in any case."""

    def __init__(self, portions: deque[list[StoredRecording[Key]]], stack: contextlib.ExitStack) -> None:
        self._portions = portions
        self._stack = stack
        self._selector = stack.enter_context(selectors.DefaultSelector())

    def answers(self, jobs: int) -> Iterator[tuple[Key, Judged | Unjudged]]:
        for _ in range(jobs):
            self._employ()
        while self._selector.get_map():
            for ready, _ in self._selector.select():
                process: JudgingProcess[Key] = ready.data
                lines = process.read()
                for line in lines or ():
                    yield process.waiting.popleft().key, read_answer(line)
                if lines is None:
                    yield from self._lost(process)
                elif not process.waiting:
                    self._go_on(process)

    def _employ(self) -> None:
        if self._portions:
            process: JudgingProcess[Key] = JudgingProcess()
            self._stack.callback(process.close)
            self._selector.register(process.answers, selectors.EVENT_READ, process)
            process.take(self._portions.popleft())

    def _go_on(self, process: JudgingProcess[Key]) -> None:
        if self._portions:
            process.take(self._portions.popleft())
        else:
            self._selector.unregister(process.answers)
            process.close()

    def _lost(self, process: JudgingProcess[Key]) -> Iterator[tuple[Key, Judged | Unjudged]]:
        self._selector.unregister(process.answers)
        unjudged = process.how_it_ended()
        process.close()
        yield process.waiting.popleft().key, unjudged
        if process.waiting:
            self._portions.appendleft(list(process.waiting))
        self._employ()
