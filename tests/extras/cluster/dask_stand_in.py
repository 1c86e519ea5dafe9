"""A fake Dask client with its futures; a test decides what happens to each."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterable
from pkgutil import resolve_name
from typing import Any

from dask.utils import apply

from course.batch.gradings import Graded, GradingTask
from course.model import codec
from course_cluster.worker import Answer
from tests.batch.samples import PASSED


class Future:
    def __init__(self, key: str, details: list[Any], options: dict[str, Any]) -> None:
        self.key = key
        self.details = details
        self.workers: list[str] = options.get("workers", [])
        self.resources: dict[str, int] = options.get("resources", {})
        self.status = "pending"
        self._value: Any = None

    @property
    def task(self) -> GradingTask:
        return codec.from_json(self.details[0], GradingTask, "the task")

    def finish(self, value: Any) -> None:
        self._end("finished", value)

    def fail(self, error: BaseException) -> None:
        self._end("error", error)

    def cancel(self) -> None:
        self._end("cancelled", None)

    def pass_(self, evidence: bytes | None = None) -> None:
        self.finish(answer_to(self.task, evidence))

    def done(self) -> bool:
        return self.status != "pending"

    def cancelled(self) -> bool:
        return self.status == "cancelled"

    def exception(self) -> BaseException | None:
        return self._value if self.status == "error" else None

    def result(self, timeout: float | None = None) -> Any:
        return self._value

    def _end(self, status: str, value: Any) -> None:
        self.status, self._value = status, value


class Client:
    """workers: addresses and their threads. look: what a worker answers when it is looked at.

    on_grade: called with each future of a grading. most: of them on their way at the same time.
    slow: a grading ends only when the coordinator looks around, for it has sent all that it may.
    """

    def __init__(self, workers: dict[str, int], on_grade: Callable[[Future], None]) -> None:
        self.status = "running"
        self.workers = workers
        self.look: Callable[[Future], None] = lambda future: future.finish(("host", None))
        self.gradings: list[Future] = []
        self.looks: list[Future] = []
        self.most = 0
        self.slow = False
        self._on_grade = on_grade

    def as_current(self) -> contextlib.AbstractContextManager[None]:
        return contextlib.nullcontext()

    def nthreads(self) -> dict[str, int]:
        pending = [future for future in self.gradings if not future.done()]
        if self.slow and pending:
            pending[0].pass_()
        return dict(self.workers)

    def submit(self, function: object, *given: Any, **options: Any) -> Any:
        """A function's name first, which Dask would look up on a worker; then its call."""
        if function is resolve_name:
            return given[0]
        assert function is apply
        future = Future(options["key"], given[1], options)
        if future.key.startswith("look-"):
            self.looks.append(future)
            self.look(future)
            return future
        self.gradings.append(future)
        self.most = max(self.most, sum(not each.done() for each in self.gradings))
        self._on_grade(future)
        return future

    def cancel(self, futures: Iterable[Future]) -> None:
        for future in futures:
            future.cancel()


def answer_to(task: GradingTask, evidence: bytes | None = None) -> Answer:
    return codec.to_json(Graded(task.unit, PASSED, 1.0)), evidence
