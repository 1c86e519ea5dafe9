"""A round of gradings on a cluster: sends as many at a time as its workers need, and no more.

Dask chooses a worker for each grading, and another one if that one dies. It chooses only among workers that
offer the resource that suitable workers give themselves (see `worker.look`). Functions are sent by name:
the scheduler, or a worker without this package, must not crash because it cannot import something.
"""

from __future__ import annotations

import threading
import time
import uuid
from asyncio import CancelledError as AsyncCancelledError
from asyncio import TimeoutError as AsyncTimeoutError
from collections import deque
from collections.abc import Callable, Generator, Iterator
from concurrent.futures import CancelledError
from dataclasses import asdict, dataclass
from pathlib import Path
from pkgutil import resolve_name
from typing import Any

from dask.utils import apply
from distributed import Client, Future, wait

from course.batch.gradings import Graded, GradingTask, NextTask
from course.batch.run import not_laid
from course.errors import CourseError, MissingHere, OurFault
from course.files import write_pieces
from course.home.opening import Refused
from course.model import codec
from course_cluster.fitness import Unfit, Wanted
from course_cluster.parcel import pack

Say = Callable[[str], None]

# What Dask raises after a timeout: two classes before Python 3.11.
TIMED_OUT = (TimeoutError, AsyncTimeoutError)
# The most bytes of submissions on their way; a single submission may be larger.
MOST_BYTES = 64_000_000
# The longest time between two looks at the workers; and how long a result may take to arrive.
_LOOK = 1.0
_FETCH = 30.0
_BEFORE_GRADINGS = 10
_WAITING = "There is no worker that may grade: waiting for one. Ctrl+C stops; the same command continues."
_RESUME = "When it is back, the same command continues where it stopped."
_NOT_INSTALLED = Unfit(
    "has no ros2course, or a different version",
    "Install the same version on it, with its extra `cluster`, then start the worker again.",
)


class Roster:
    """Looks at each worker when it appears, and again if it comes back under another address.

    say: takes a sentence for the instructor.
    """

    def __init__(self, client: Client, wanted: Wanted, say: Say) -> None:
        self._client = client
        self._wanted = wanted
        self._say = say
        self._threads: dict[str, int] = {}
        self._asked: dict[str, Future] = {}
        self._fit: dict[str, str] = {}
        self._unfit: dict[str, str] = {}

    @property
    def fit(self) -> dict[str, int]:
        """The workers that may grade, by address, and how many gradings each does at once."""
        return {address: self._threads[address] for address in self._fit}

    @property
    def looking(self) -> list[Future]:
        """Looks that have not ended yet, at workers that may turn out to be suitable."""
        return [*self._asked.values()]

    @property
    def hosts(self) -> int:
        """The number of their machines."""
        return len(set(self._fit.values()))

    @property
    def all_unfit(self) -> CourseError | None:
        """The error to end with if there are workers, but none of them will ever be able to grade."""
        if not self._unfit or self._fit or self._asked:
            return None
        count = len(self._unfit)
        which = "The cluster's only worker" if count == 1 else f"None of the cluster's {count} workers"
        return MissingHere(
            f"{which} can{'not' if count == 1 else ''} be used.", "The messages above say what to do."
        )

    def look(self) -> None:
        """See which workers came and went. Raises MissingHere if the scheduler does not answer."""
        if self._client.status != "running":
            raise _lost()
        try:
            self._threads = self._client.nthreads()
        except (OSError, *TIMED_OUT) as error:
            raise _lost(error) from error
        for known in (self._asked, self._fit, self._unfit):
            for address in known.keys() - self._threads.keys():
                known.pop(address)
        for address in self._threads.keys() - self._fit.keys() - self._unfit.keys():
            self._take(address)

    def _take(self, address: str) -> None:
        if address not in self._asked:
            here = {"workers": [address], "allow_other_workers": False, "priority": _BEFORE_GRADINGS}
            self._asked[address] = call(self._client, "look", asdict(self._wanted), **here)
        elif self._asked[address].done():
            self._hear(address, self._asked.pop(address))

    def _hear(self, address: str, future: Future) -> None:
        if future.cancelled():
            return  # it is asked again if it is still there
        host, problem = _answer(future)
        if problem is None:
            self._fit[address] = host
            return
        self._unfit[address] = host
        place = f"{address} ({host})" if host else address
        self._say(f"Worker {place} is not used: it {problem.why.rstrip('.')}. {problem.advice}")


def call(client: Client, name: str, *details: object, **options: Any) -> Future:
    """Make a worker call the function `name` of `course_cluster.worker`. options: for Dask's `submit`.

    details: plain data. If a worker has no such function, the result is an ImportError or AttributeError.
    """
    options |= {"pure": False}
    function = client.submit(resolve_name, f"course_cluster.worker:{name}", **options)
    return client.submit(apply, function, [*details], key=f"{name}-{uuid.uuid4().hex}", **options)


def _answer(future: Future) -> tuple[str, Unfit | None]:
    """A worker's machine, and why it may not grade."""
    error = future.exception()
    if isinstance(error, (ImportError, AttributeError, TypeError)):
        return "", _NOT_INSTALLED
    if error is not None:
        return "", Unfit(f"failed when it was looked at: {error!r}", _NOT_INSTALLED.advice)
    host, problem = future.result()
    return host, Unfit(*problem) if problem else None


def _lost(error: BaseException | None = None) -> MissingHere:
    """The error if the scheduler is gone."""
    return MissingHere(f"The scheduler no longer answers{f': {error}' if error else ''}.", _RESUME)


@dataclass(frozen=True)
class Sent:
    """A task on its way. size: bytes."""

    task: GradingTask
    size: int


class Cluster:
    """Grades rounds of tasks on the workers of `client` (see `course.batch.run.Rounds`).

    most: gradings at once in the whole cluster; None for the number of its workers' threads. say: takes a
    sentence for the instructor. on_look: called about once a second; ends everything if it raises.
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
        self._resources = {wanted.resource: 1}
        self._say = say
        self._most = most
        self._on_look = on_look
        self._roster = Roster(client, wanted, say)
        self._sent: dict[Future, Sent] = {}
        self._ready: deque[Graded] = deque()
        self._waits = False
        self._next_look = 0.0
        self._fit_before: set[str] = set()

    def __call__(self, next_task: NextTask, *, waiting: int, alone: bool) -> Generator[Graded, None, None]:
        """When the iteration ends, whatever the reason, unfinished tasks are canceled."""
        more = True
        try:
            while more or self._sent:
                self._look(alone)
                more = more and self._fill(next_task, alone)
                self._tell_if_waiting()
                yield from self._arrivals(alone)
        finally:
            self._client.cancel([*self._sent])
            self._sent.clear()

    def _look(self, alone: bool) -> None:
        if time.monotonic() >= self._next_look:
            self._next_look = time.monotonic() + _LOOK
            self._on_look()
            self._roster.look()
            now = set(self._roster.fit)
            if now and not now & self._fit_before:
                self._send_again(alone)
            self._fit_before = now or self._fit_before

    def _send_again(self, alone: bool) -> None:
        """Send all tasks again, because no worker that could grade is left.

        Dask assigns waiting tasks only when a worker appears, and ours say later that they can grade.
        """
        waiting = [sent.task for sent in self._sent.values()]
        self._client.cancel([*self._sent])
        self._sent.clear()
        for task in waiting:
            self._send(task, alone)

    def _room(self, alone: bool) -> int:
        """How many tasks may be on their way: those being graded, and the next one for each worker."""
        fit = self._roster.fit
        if alone:
            return self._roster.hosts
        return min(sum(fit.values()) + len(fit), self._most or sum(fit.values()) + len(fit))

    def _fill(self, next_task: NextTask, alone: bool) -> bool:
        """Send as many tasks as there is room for. False if there are no more tasks."""
        while len(self._sent) < self._room(alone) and self._bytes() < MOST_BYTES:
            task = next_task()
            if task is None:
                return False
            self._send(task, alone)
        return True

    def _bytes(self) -> int:
        return sum(sent.size for sent in self._sent.values())

    def _send(self, task: GradingTask, alone: bool) -> None:
        try:
            home = pack(Path(task.home))
        except Refused as error:
            self._ready.append(not_laid(task.unit, error))
            return
        future = call(self._client, "grade", codec.to_json(task), home, alone, resources=self._resources)
        self._sent[future] = Sent(task, len(home))

    def _tell_if_waiting(self) -> None:
        if self._roster.fit:
            self._waits = False
        elif (error := self._roster.all_unfit) and not self._sent:
            raise error
        elif not self._waits and not self._roster.looking:
            self._waits = True
            self._say(_WAITING)

    def _arrivals(self, alone: bool) -> Iterator[Graded]:
        """Results that came back. Wait for the first one, but only until the next look at the workers."""
        while self._ready:
            yield self._ready.popleft()
        looking = self._roster.looking
        for future in _done(self._client, [*self._sent, *looking]):
            if future in looking:
                self._next_look = 0.0
            elif graded := self._graded(future, self._sent.pop(future), alone):
                yield graded

    def _graded(self, future: Future, sent: Sent, alone: bool) -> Graded | None:
        """The grading; None if it is not final, so that we must wait for it again."""
        if future.cancelled():  # not by us: somebody restarted the workers, or the scheduler is gone
            self._roster.look()
            self._send(sent.task, alone)
            return None
        if future.status == "error":
            error = future.exception()
            what = f"The worker that graded it failed: {type(error).__name__}: {error}"
            return not_laid(sent.task.unit, OurFault(what))
        try:
            line, evidence = future.result(timeout=_FETCH)
        except TIMED_OUT:  # its worker died, so another one grades it
            self._sent[future] = sent
            return None
        except OSError as error:
            raise _lost(error) from error
        return _kept(sent.task, line, evidence)


def _done(client: Client, futures: list[Future]) -> list[Future]:
    """The finished ones; wait for one, but only until the next look at the workers."""
    if not futures:
        threading.Event().wait(_LOOK)
        return []
    try:
        with client.as_current():
            wait(futures, timeout=_LOOK, return_when="FIRST_COMPLETED")
    except (*TIMED_OUT, CancelledError, AsyncCancelledError):  # Dask raises one or the other
        pass
    return [future for future in futures if future.done()]


def _kept(task: GradingTask, line: str, evidence: bytes | None) -> Graded:
    """The grading, after its recording was stored. Raises StorageError."""
    graded = codec.from_json(line, Graded, "the answer")
    if graded.unit != task.unit:
        return not_laid(task.unit, OurFault("The worker answered for something else."))
    if evidence is not None:
        write_pieces(Path(task.evidence), [evidence])
    return graded
