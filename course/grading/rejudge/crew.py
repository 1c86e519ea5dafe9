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
from collections import deque
from collections.abc import Iterable, Iterator
from itertools import islice
from pathlib import Path
from typing import Generic

from course.grading.rejudge.model import (
    PORTION,
    Key,
    Problem,
    Rejudged,
    Stored,
    Trouble,
    answer_from_line,
)
from course.grading.rejudge.process import Judges


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
        while portion := list(islice(rest, PORTION)):
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
                worker: Judges[Key] = ready.data
                lines = worker.read()
                for line in lines or ():
                    yield worker.waiting.popleft().key, answer_from_line(line)
                if lines is None:
                    yield from self._lost(worker)
                elif not worker.waiting:
                    self._go_on(worker)

    def _employ(self) -> None:
        if self._portions:
            worker: Judges[Key] = Judges()
            self._stack.callback(worker.close)
            self._selector.register(worker.answers, selectors.EVENT_READ, worker)
            worker.take(self._portions.popleft())

    def _go_on(self, worker: Judges[Key]) -> None:
        if self._portions:
            worker.take(self._portions.popleft())
        else:
            self._selector.unregister(worker.answers)
            worker.close()

    def _lost(self, worker: Judges[Key]) -> Iterator[tuple[Key, Problem]]:
        self._selector.unregister(worker.answers)
        problem = Problem(Trouble.FATAL, worker.how_it_ended())
        worker.close()
        yield worker.waiting.popleft().key, problem
        if worker.waiting:
            self._portions.appendleft(list(worker.waiting))
        self._employ()
