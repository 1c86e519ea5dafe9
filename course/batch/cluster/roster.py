"""The workers of a cluster as the coordinator knows them: who is there, who may grade, and who may not."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict
from typing import TYPE_CHECKING

from course.batch.cluster.calling import TIMED_OUT, call
from course.batch.cluster.fitness import Unfit, Wanted
from course.batch.cluster.station import look_at_this_worker
from course.errors import CourseError, MissingHere

if TYPE_CHECKING:
    from distributed import Client, Future

Say = Callable[[str], None]
_BEFORE_GRADINGS = 10
_RESUME = "When it is there again, the same command goes on where it was."
_NOT_INSTALLED = Unfit(
    "has no ros2course, or one of another version",
    "Install the same version on it, with its extra `cluster`, then start the worker again.",
)


class Roster:
    """Each worker is looked at when it is first seen, and again when it comes back under another address.

    wake: called, from another thread, when there is news. say: takes a sentence for the instructor.
    """

    def __init__(self, client: Client, wanted: Wanted, wake: Callable[[], None], say: Say) -> None:
        self._client = client
        self._wanted = wanted
        self._wake = wake
        self._say = say
        self._threads: dict[str, int] = {}
        self._asked: dict[str, Future] = {}
        self._fit: dict[str, str] = {}
        self._unfit: dict[str, str] = {}

    @property
    def fit(self) -> dict[str, int]:
        """Addresses of those that may grade, and how many gradings each does at once."""
        return {address: self._threads[address] for address in self._fit}

    @property
    def looking(self) -> bool:
        """Whether a worker is being looked at, so that it may turn out to be fit."""
        return bool(self._asked)

    @property
    def hosts(self) -> int:
        """How many machines they are on."""
        return len(set(self._fit.values()))

    @property
    def all_unfit(self) -> CourseError | None:
        """The error to end with when there are workers and none of them may ever grade."""
        if not self._unfit or self._fit or self.looking:
            return None
        count = len(self._unfit)
        which = "The cluster's only worker" if count == 1 else f"None of the cluster's {count} workers"
        return MissingHere(f"{which} can{'not' if count == 1 else ''} be used.", "What to do stands above.")

    def look(self) -> None:
        """See who has come and who has gone. Raises MissingHere when the scheduler does not answer."""
        if self._client.status != "running":
            raise lost()
        try:
            self._threads = self._client.nthreads()
        except (OSError, *TIMED_OUT) as error:
            raise lost(error) from error
        for known in (self._asked, self._fit, self._unfit):
            for address in [*known]:
                if address not in self._threads:
                    known.pop(address)
        for address in self._threads:
            self._take(address)

    def _take(self, address: str) -> None:
        if address in self._fit or address in self._unfit:
            return
        if address not in self._asked:
            self._asked[address] = self._ask(address)
        elif self._asked[address].done():
            self._hear(address, self._asked.pop(address))

    def _ask(self, address: str) -> Future:
        here = {"workers": [address], "allow_other_workers": False, "priority": _BEFORE_GRADINGS}
        future = call(self._client, look_at_this_worker, asdict(self._wanted), kind="look", **here)
        future.add_done_callback(lambda _: self._wake())
        return future

    def _hear(self, address: str, future: Future) -> None:
        if future.status == "cancelled":
            return  # it will be asked again, if it is still there
        host, problem = _heard(future)
        if problem is None:
            self._fit[address] = host
            return
        self._unfit[address] = host
        place = f"{address} ({host})" if host else address
        self._say(f"Worker {place} is not used: it {problem.why.rstrip('.')}. {problem.advice}")


def lost(error: BaseException | None = None) -> MissingHere:
    """The scheduler is gone."""
    return MissingHere(f"The scheduler does not answer any more{f': {error}' if error else ''}.", _RESUME)


def _heard(future: Future) -> tuple[str, Unfit | None]:
    """Its machine's name, and why it may not grade."""
    error = future.exception()
    if isinstance(error, (ImportError, AttributeError, TypeError)):
        return "", _NOT_INSTALLED
    if error is not None:
        return "", Unfit(f"failed when it was looked at: {error!r}", _NOT_INSTALLED.advice)
    host, problem = future.result()
    return host, Unfit(*problem) if problem else None
