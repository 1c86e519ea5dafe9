"""Recordings in, judgements out: the parent's side of the processes that judge.

A worker takes portions of recordings whose checks are in one module, for which pytest collects once. It
answers in order, so a worker that dies has died of the recording whose answer is missing: that one is a
problem, and another worker takes the rest. Nothing is read before it is asked for: who takes the answers
slowly slows the workers down, and nothing piles up.
"""

from __future__ import annotations

import contextlib
import os
import selectors
import signal
import subprocess
import sys
import tempfile
from collections import deque
from collections.abc import Iterable, Iterator
from itertools import islice
from pathlib import Path
from typing import Generic

import course
from course.errors import OurFault
from course.grading.rejudge.model import (
    MOST_TIME,
    Key,
    Portion,
    Problem,
    Rejudged,
    Stored,
    Trouble,
    answer_from_line,
    portion_to_line,
)

_WORKER = "course.grading.rejudge.worker"
# So many share one collection by pytest (some 50 ms), and at most so many reports that it keeps.
_PORTION = 50
_CHUNK = 1 << 16
_LOG = 2000
# No preparation for ROS by the wheels, which takes longer than ten recordings; no plugins but ours.
_QUICK = {"_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1", "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}


def rejudge(
    recordings: Iterable[Stored[Key]], *, jobs: int | None = None
) -> Iterator[tuple[Key, Rejudged | Problem]]:
    """Judge each recording by the checks of its exercise as they are now. In no particular order.

    jobs: processes at once; as many as there are cores by default. Whatever is wrong with one recording is
    told of that one only; where a grader cannot be run, its judgements have a `fault`. To stop early, close
    the iterator. Questions are not judged here: see `regraded`. Raises OurFault when no process can be
    started.
    """
    portions = deque(_portions(recordings))
    most = min(jobs or len(os.sched_getaffinity(0)), len(portions))
    with contextlib.ExitStack() as stack:
        yield from _Crew(portions, stack).answers(most)


def _portions(recordings: Iterable[Stored[Key]]) -> Iterator[list[Stored[Key]]]:
    modules: dict[Path, list[Stored[Key]]] = {}
    for stored in recordings:
        modules.setdefault(stored.exercise.grader, []).append(stored)
    for every in modules.values():
        rest = iter(every)
        while portion := list(islice(rest, _PORTION)):
            yield portion


class _Crew(Generic[Key]):
    """Workers, each with its portion. stack: ends them, however this ends."""

    def __init__(self, portions: deque[list[Stored[Key]]], stack: contextlib.ExitStack) -> None:
        self._portions = portions
        self._stack = stack
        self._selector = stack.enter_context(selectors.DefaultSelector())

    def answers(self, jobs: int) -> Iterator[tuple[Key, Rejudged | Problem]]:
        for _ in range(jobs):
            self._employ()
        while self._selector.get_map():
            for ready, _ in self._selector.select():
                worker: _Worker[Key] = ready.data
                lines = worker.read()
                for line in lines or ():
                    yield worker.waiting.popleft().key, answer_from_line(line)
                if lines is None:
                    yield from self._lost(worker)
                elif not worker.waiting:
                    self._go_on(worker)

    def _employ(self) -> None:
        if self._portions:
            worker: _Worker[Key] = _Worker()
            self._stack.callback(worker.close)
            self._selector.register(worker.answers, selectors.EVENT_READ, worker)
            worker.take(self._portions.popleft())

    def _go_on(self, worker: _Worker[Key]) -> None:
        if self._portions:
            worker.take(self._portions.popleft())
        else:
            self._selector.unregister(worker.answers)
            worker.close()

    def _lost(self, worker: _Worker[Key]) -> Iterator[tuple[Key, Problem]]:
        self._selector.unregister(worker.answers)
        problem = Problem(Trouble.FATAL, worker.how_it_ended())
        worker.close()
        yield worker.waiting.popleft().key, problem
        if worker.waiting:
            self._portions.appendleft(list(worker.waiting))
        self._employ()


class _Worker(Generic[Key]):
    """A process. waiting: what it has been given and has not answered. answers: where it does."""

    def __init__(self) -> None:
        self.waiting: deque[Stored[Key]] = deque()
        self._ready = False
        self._rest = b""
        with contextlib.ExitStack() as stack:
            self._log = stack.enter_context(tempfile.TemporaryFile("w+", errors="replace"))
            self.answers, theirs = os.pipe()
            stack.callback(os.close, self.answers)
            try:
                self._process = stack.enter_context(_start(theirs, self._log.fileno()))
            finally:
                os.close(theirs)
            stack.callback(self._process.kill)
            self._stack = stack.pop_all()

    def take(self, portion: list[Stored[Key]]) -> None:
        self.waiting.extend(portion)
        exercises = {stored.exercise.id: stored.exercise for stored in portion}
        looks_at = {name: (*one.files, *one.looks_at) for name, one in exercises.items()}
        files = [(stored.exercise.id, str(stored.file)) for stored in portion]
        line = portion_to_line(Portion(str(portion[0].exercise.grader), looks_at, files))
        assert self._process.stdin is not None
        with contextlib.suppress(BrokenPipeError):  # it is read that it ended
            self._process.stdin.write(line + "\n")
            self._process.stdin.flush()

    def read(self) -> list[str] | None:
        """What it answered since; None when it has ended."""
        data = os.read(self.answers, _CHUNK)
        if not data:
            return None
        *lines, self._rest = (self._rest + data).split(b"\n")
        if lines and not self._ready:
            self._ready = True
            del lines[0]
        return [line.decode() for line in lines]

    def how_it_ended(self) -> str:
        """Raises OurFault when it never began."""
        code = self._process.wait()
        if not self._ready:
            self._log.seek(0)
            raise OurFault(f"recordings cannot be judged here: {self._log.read()[-_LOG:].strip()}")
        if code == -signal.SIGALRM:
            return f"Judging it took more than {MOST_TIME} s."
        how = f"by signal {-code}" if code < 0 else f"with {code}"
        return f"The process that judged it was ended {how}."

    def close(self) -> None:
        """End it; more than once does no harm."""
        with contextlib.suppress(BrokenPipeError):
            self._stack.close()


def _start(answers: int, log: int) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-m", _WORKER, str(answers)],
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
    own = str(Path(course.__file__).parents[1])
    path = os.pathsep.join(part for part in (own, os.environ.get("PYTHONPATH")) if part)
    others = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST_")}
    return {**others, **_QUICK, "PYTHONPATH": path}
