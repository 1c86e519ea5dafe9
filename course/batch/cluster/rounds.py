"""A round of gradings on a cluster: as many on their way as its workers need, and no more."""

from __future__ import annotations

import queue
import time
from collections import deque
from collections.abc import Callable, Generator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from course.batch.cluster.calling import TIMED_OUT, call
from course.batch.cluster.fitness import Wanted
from course.batch.cluster.parcel import pack
from course.batch.cluster.roster import Roster, Say, lost
from course.batch.cluster.station import Answer, grade_on_this_worker
from course.batch.gradings import NextTask
from course.batch.model import Graded, Task, graded_from_line, task_to_line
from course.batch.run import not_laid
from course.errors import OurFault
from course.home.opening import Refused
from course.report.gradebook.files import write

if TYPE_CHECKING:
    from distributed import Client, Future

# Bytes of submissions on their way, at the most; one travels whatever its size.
MOST_BYTES = 64_000_000
# How often to see who has come and who has gone, at least; and how long a result may take to arrive.
_LOOK = 1.0
_FETCH = 30.0
_NEWS = ""
_WAITING = "No worker is there: waiting for one. Ctrl+C stops; the same command goes on where it was stopped."


@dataclass(frozen=True)
class Sent:
    """A task on its way. workers: those that may do it; Dask chooses, and chooses anew when one dies."""

    task: Task
    future: Future
    workers: frozenset[str]
    size: int


class Cluster:
    """The workers behind `client`, as what grades a round of tasks (see `course.batch.run.Rounds`).

    most: gradings at once in the whole cluster, None for as many as its workers have threads.
    say: takes a sentence for the instructor. on_look: called about once a second; ends all if it raises.
    """

    def __init__(
        self,
        client: Client,
        wanted: Wanted,
        say: Say,
        most: int | None = None,
        on_look: Callable[[], None] = lambda: None,
    ) -> None:
        self._client = client
        self._say = say
        self._most = most
        self._on_look = on_look
        self._news: queue.SimpleQueue[str] = queue.SimpleQueue()
        self._roster = Roster(client, wanted, lambda: self._news.put(_NEWS), say)
        self._sent: dict[str, Sent] = {}
        self._ready: deque[Graded] = deque()
        self._waits = False
        self._next_look = 0.0

    def __call__(self, next_task: NextTask, *, waiting: int, alone: bool) -> Generator[Graded, None, None]:
        """Whatever ends the iteration calls off what is still on its way."""
        more = True
        try:
            while more or self._sent:
                if time.monotonic() >= self._next_look:
                    self._look(alone)
                more = more and self._fill(next_task, alone)
                self._tell_if_waiting()
                yield from self._arrivals(alone)
        finally:
            self._client.cancel([sent.future for sent in self._sent.values()])
            self._sent.clear()

    def _room(self, alone: bool) -> int:
        """How many tasks may be on their way: those being graded, and one for each worker to go on with."""
        fit = self._roster.fit
        if alone:
            return self._roster.hosts
        return min(sum(fit.values()) + len(fit), self._most or sum(fit.values()) + len(fit))

    def _fill(self, next_task: NextTask, alone: bool) -> bool:
        """Send what there is room for. False when there are no more tasks."""
        while len(self._sent) < self._room(alone) and self._bytes() < MOST_BYTES:
            task = next_task()
            if task is None:
                return False
            self._send(task, alone)
        return True

    def _bytes(self) -> int:
        return sum(sent.size for sent in self._sent.values())

    def _send(self, task: Task, alone: bool) -> None:
        try:
            home = pack(Path(task.home))
        except Refused as error:
            self._ready.append(not_laid(task.unit, error))
            return
        workers = frozenset(self._roster.fit)
        details = (task_to_line(task), home, alone)
        future = call(self._client, grade_on_this_worker, *details, kind="grade", workers=[*workers])
        self._sent[future.key] = Sent(task, future, workers, len(home))
        future.add_done_callback(lambda done: self._news.put(done.key))

    def _look(self, alone: bool) -> None:
        self._next_look = time.monotonic() + _LOOK
        self._on_look()
        self._roster.look()
        self._rescue(alone)

    def _rescue(self, alone: bool) -> None:
        """Dask gives the tasks of a dead worker to another that may do them; where none is left, we do."""
        fit = self._roster.fit
        for key, sent in [*self._sent.items()]:
            if fit and sent.workers.isdisjoint(fit) and not sent.future.done():
                self._sent.pop(key)
                self._client.cancel([sent.future])
                self._send(sent.task, alone)

    def _tell_if_waiting(self) -> None:
        if self._roster.fit:
            self._waits = False
        elif error := self._roster.all_unfit:
            if not self._sent:
                raise error
        elif not self._waits and not self._roster.looking:
            self._waits = True
            self._say(_WAITING)

    def _arrivals(self, alone: bool) -> Generator[Graded, None, None]:
        """What has come back. Waits for the first, but no longer than until it is time to look around."""
        while self._ready:
            yield self._ready.popleft()
        try:
            key = self._news.get(timeout=_LOOK)
        except queue.Empty:
            return
        if key == _NEWS:
            self._next_look = 0.0
        # What nobody waits for any more is no result: each task counts once.
        sent = self._sent.pop(key, None)
        if sent and (graded := self._answer_to(key, sent, alone)):
            yield graded

    def _answer_to(self, key: str, sent: Sent, alone: bool) -> Graded | None:
        """None when it has to be waited for again."""
        if sent.future.cancelled():  # not by us: somebody restarted the workers, or the scheduler is gone
            self._roster.look()
            self._send(sent.task, alone)
            return None
        if sent.future.status == "error":
            return not_laid(sent.task.unit, OurFault(_words(sent.future.exception())))
        try:
            answer: Answer = sent.future.result(timeout=_FETCH)
        except TIMED_OUT:  # its worker died with it: it is being graded again
            self._sent[key] = sent
            sent.future.add_done_callback(lambda done: self._news.put(done.key))
            return None
        except OSError as error:
            raise lost(error) from error
        return _kept(sent.task, answer)


def _kept(task: Task, answer: Answer) -> Graded:
    """The grading, once its recording is where it belongs. Raises StorageError."""
    line, evidence = answer
    graded = graded_from_line(line)
    if graded.unit != task.unit:
        return not_laid(task.unit, OurFault("The worker answered for something else."))
    if evidence is not None:
        write(Path(task.evidence), [evidence])
    return graded


def _words(error: BaseException | None) -> str:
    return f"The worker that graded it failed: {type(error).__name__}: {error}"
