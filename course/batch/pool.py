"""Worker processes on this machine: tasks in, answers out, whatever happens to a worker."""

from __future__ import annotations

import contextlib
import queue
import subprocess
import threading
import time
from collections.abc import Callable, Generator
from dataclasses import dataclass
from typing import Generic, TypeVar

from course.child import Child
from course.errors import DamagedData
from course.model import codec

_END_TIME = 10.0
_DEATH_TIME = 1.0
# After this, a worker is assumed to hang: no exercise may take that long, even with its build.
TIME_LIMIT = 1800.0

Say = Callable[[str], None]
Task = TypeVar("Task")
Answer = TypeVar("Answer")


@dataclass(frozen=True)
class Work(Generic[Task, Answer]):
    """What workers do. worker: the module that is run, with the descriptor for its answers as argument.

    answer: the type of what it answers. fits: whether an answer belongs to this task. failed: makes the
    answer when the worker failed, from a text that continues `The worker`, such as `ended with -9`.
    """

    worker: str
    answer: type[Answer]
    fits: Callable[[Task, Answer], bool]
    failed: Callable[[Task, str], Answer]


class Pool(Generic[Task, Answer]):
    """`jobs` workers, each of which asks for its next task by itself.

    next_task: called from several threads, one at a time; returns None when nothing is left to do.
    say: called from several threads with what a worker is doing.
    """

    def __init__(
        self,
        work: Work[Task, Answer],
        jobs: int,
        next_task: Callable[[], Task | None],
        say: Say = lambda text: None,
    ) -> None:
        self._work = work
        self._say = say
        self._next_task = next_task
        self._one_at_a_time = threading.Lock()
        self._done: queue.Queue[tuple[Answer] | BaseException | None] = queue.Queue()
        self._stopping = threading.Event()
        self._workers: list[Worker[Task, Answer]] = []
        self._threads = [threading.Thread(target=self._look_after, name=f"worker {n}") for n in range(jobs)]

    def results(self) -> Generator[Answer, None, None]:
        """Answers as they come, until nothing is left to do. Whatever ends the iteration ends the workers."""
        for thread in self._threads:
            thread.start()
        try:
            running = len(self._threads)
            while running:
                found = self._done.get()
                if isinstance(found, BaseException):
                    raise found
                if found is None:
                    running -= 1
                else:
                    yield found[0]
        finally:
            self._stop()

    def _stop(self) -> None:
        self._stopping.set()
        for end in (Worker.interrupt, Worker.kill):  # the latter for those that do not react
            for worker in list(self._workers):
                end(worker)
            deadline = time.monotonic() + _END_TIME
            for thread in self._threads:
                thread.join(max(0.0, deadline - time.monotonic()))

    def _look_after(self) -> None:
        """One thread per worker. The kernel ends the worker when its thread ends."""
        try:
            with contextlib.closing(Worker(self._work, self._say)) as worker:
                self._workers.append(worker)
                while (task := self._take()) is not None:
                    self._done.put((worker.do(task),))
            self._done.put(None)
        except BaseException as error:  # noqa: BLE001 - raised in the main thread
            self._done.put(error)

    def _take(self) -> Task | None:
        with self._one_at_a_time:
            return None if self._stopping.is_set() else self._next_task()


class Worker(Generic[Task, Answer]):
    """A process that is started when it is needed, and again after it died."""

    def __init__(self, work: Work[Task, Answer], say: Say = lambda text: None) -> None:
        self._work = work
        self._say = say
        self._child: Child | None = None

    def do(self, task: Task) -> Answer:
        self._child = self._child or Child(self._work.worker)
        self._child.tell(task)
        try:
            while (line := self._child.readline(TIME_LIMIT) or b"").startswith(b'"'):
                self._say(codec.from_json(line, str, "this line"))
            answer = codec.from_json(line, self._work.answer, "this line")
        except TimeoutError:
            return self._fell(task, f"did not finish within {TIME_LIMIT:.0f} s")
        except DamagedData:
            return self._fell(task, _how_it_ended(self._child))
        if not self._work.fits(task, answer):
            return self._fell(task, "answered for something else")
        return answer

    def interrupt(self) -> None:
        if (child := self._child) is not None:
            child.process.terminate()

    def kill(self) -> None:
        if (child := self._child) is not None:
            child.process.kill()

    def close(self) -> None:
        child, self._child = self._child, None
        if child is not None:
            child.close(_END_TIME)

    def _fell(self, task: Task, how: str) -> Answer:
        self.kill()
        self.close()
        return self._work.failed(task, how)


def _how_it_ended(child: Child) -> str:
    try:
        return f"ended with {child.process.wait(_DEATH_TIME)}"
    except subprocess.TimeoutExpired:
        return "answered in words that make no sense"
