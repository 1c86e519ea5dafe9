"""Worker processes of this machine: tasks in, answers out, whatever becomes of a worker."""

from __future__ import annotations

import contextlib
import os
import queue
import select
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Generator
from dataclasses import dataclass
from pathlib import Path
from typing import Generic, TypeVar

import course

_END_TIME = 10.0
_DEATH_TIME = 1.0
# After this a worker is thought to hang: no exercise with its build may take as long.
TIME_LIMIT = 1800.0

Task = TypeVar("Task")
Answer = TypeVar("Answer")


@dataclass(frozen=True)
class Work(Generic[Task, Answer]):
    """What workers do. worker: the module that is run, with the descriptor for its answers as argument.

    write: a task as a line. read: an answer of a line; raises ValueError, KeyError or TypeError when no
    worker wrote it. fits: whether the answer is one to this task. failed: the answer when the worker fell;
    the text goes on after «The worker», e.g. «ended with -9».
    """

    worker: str
    write: Callable[[Task], str]
    read: Callable[[str], Answer]
    fits: Callable[[Task, Answer], bool]
    failed: Callable[[Task, str], Answer]


class Pool(Generic[Task, Answer]):
    """`jobs` workers, each of which asks for its next task by itself.

    next_task: called from several threads, one at a time; None when there is nothing (more) to do.
    """

    def __init__(self, work: Work[Task, Answer], jobs: int, next_task: Callable[[], Task | None]) -> None:
        self._work = work
        self._next_task = next_task
        self._one_at_a_time = threading.Lock()
        self._done: queue.Queue[tuple[Answer] | BaseException | None] = queue.Queue()
        self._stopping = threading.Event()
        self._workers: list[Worker[Task, Answer]] = []
        self._threads = [threading.Thread(target=self._look_after, name=f"worker {n}") for n in range(jobs)]

    def results(self) -> Generator[Answer, None, None]:
        """As they come, until there is no more to do. Whatever ends the iteration ends the workers."""
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
        for end in (Worker.interrupt, Worker.kill):  # the latter for who does not listen
            for worker in list(self._workers):
                end(worker)
            deadline = time.monotonic() + _END_TIME
            for thread in self._threads:
                thread.join(max(0.0, deadline - time.monotonic()))

    def _look_after(self) -> None:
        """One thread looks after one worker. The kernel ends the worker with this thread, too."""
        try:
            with contextlib.closing(Worker(self._work)) as worker:
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
    """A process that is started when it is needed, and anew when it died."""

    def __init__(self, work: Work[Task, Answer]) -> None:
        self._work = work
        self._process: subprocess.Popen[str] | None = None

    def do(self, task: Task) -> Answer:
        if self._process is None:
            self._start()
        assert self._process is not None and self._process.stdin is not None
        with contextlib.suppress(BrokenPipeError):
            self._process.stdin.write(self._work.write(task) + "\n")
            self._process.stdin.flush()
        if not select.select([self._reader], [], [], TIME_LIMIT)[0]:
            return self._fell(task, f"did not finish within {TIME_LIMIT:.0f} s")
        try:
            answer = self._work.read(self._reader.readline())
        except (ValueError, KeyError, TypeError):
            return self._fell(task, self._how_it_ended())
        if not self._work.fits(task, answer):
            return self._fell(task, "answered for something else")
        return answer

    def interrupt(self) -> None:
        if (process := self._process) is not None:
            process.terminate()

    def kill(self) -> None:
        if (process := self._process) is not None:
            process.kill()

    def close(self) -> None:
        process, self._process = self._process, None
        if process is None:
            return
        if process.stdin:
            with contextlib.suppress(OSError):
                process.stdin.close()
        try:
            process.wait(_END_TIME)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        self._reader.close()

    def _start(self) -> None:
        reading, writing = os.pipe()
        try:
            self._process = subprocess.Popen(
                [sys.executable, "-m", self._work.worker, str(writing)],
                stdin=subprocess.PIPE,
                stdout=subprocess.DEVNULL,
                env=_environment(),
                pass_fds=(writing,),
                # Ctrl+C at the terminal is for us; we end the workers in order.
                start_new_session=True,
                text=True,
            )
        finally:
            os.close(writing)
        self._reader = os.fdopen(reading, encoding="utf-8")

    def _how_it_ended(self) -> str:
        assert self._process is not None
        try:
            return f"ended with {self._process.wait(_DEATH_TIME)}"
        except subprocess.TimeoutExpired:
            return "answered in words that make no sense"

    def _fell(self, task: Task, how: str) -> Answer:
        """The next task gets a new worker."""
        self.kill()
        self.close()
        return self._work.failed(task, how)


def _environment() -> dict[str, str]:
    own = str(Path(course.__file__).parents[1])
    path = os.pathsep.join(part for part in (own, os.environ.get("PYTHONPATH")) if part)
    return {**os.environ, "PYTHONPATH": path}
