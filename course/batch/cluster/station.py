"""What runs on a Dask worker: each grading in a process of its own, in a folder that is gone afterwards."""

from __future__ import annotations

import contextlib
import os
import tempfile
import threading
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from course.batch.cluster.fitness import Wanted, engine_digest, host, unfit
from course.batch.cluster.parcel import evidence_of, unpack
from course.batch.cluster.turn import turn
from course.batch.gradings import GradingProcess
from course.batch.model import Graded, Task, graded_to_line, task_from_line
from course.batch.run import default_jobs, not_laid
from course.errors import StorageError
from course.home.opening import Refused
from course.rosenv import cache_dir
from course.rosenv.files import wipe

if TYPE_CHECKING:
    from distributed import Worker

_NAME = "ros2course"


# The grading, as `graded_to_line` writes it, and its recording, if there is one.
Answer = tuple[str, bytes | None]


def look_at_this_worker(asked: Mapping[str, Any]) -> tuple[str, tuple[str, str] | None]:
    """A Dask task: the name of this machine, and why it may not grade (see Unfit). asked: a Wanted."""
    from distributed import get_worker

    problem = unfit(Wanted(**asked), _station_of(get_worker()).engine)
    return host(), (problem.why, problem.advice) if problem else None


def grade_on_this_worker(line: str, home: bytes, alone: bool) -> Answer:
    """A Dask task. line: the course's task, whose paths are the coordinator's.

    home: as `parcel.pack` made it. alone: with no other grading beside it on this machine.
    """
    from distributed import get_worker

    worker = get_worker()
    key, scratch = worker.get_current_task(), Path(worker.local_directory)
    return _station_of(worker).grade(key, task_from_line(line), home, alone, scratch)


def _station_of(worker: Worker) -> Station:
    from distributed.utils import sync

    async def found() -> Station:  # in the worker's own thread, which goes through its plugins all the time
        if _NAME not in worker.plugins:
            worker.plugins[_NAME] = Station()
        station: Station = worker.plugins[_NAME]
        return station

    station: Station = sync(worker.loop, found)
    return station


class Station:
    """A plugin of a Dask worker. Each of the worker's threads keeps a grading process, which ends with it."""

    def __init__(self) -> None:
        self.engine = engine_digest()  # of what was imported; its files may be replaced at any time
        self._room = threading.BoundedSemaphore(default_jobs())
        self._own = threading.local()
        self._lock = threading.Lock()
        self._running: dict[str, GradingProcess | None] = {}
        self._processes: list[GradingProcess] = []

    def grade(self, key: str, task: Task, home: bytes, alone: bool, scratch: Path) -> Answer:
        with self._known(key), self._room, turn(_gate(), alone=alone):
            try:
                with _folder(scratch) as folder:
                    return self._graded(key, task, home, folder)
            except (Refused, StorageError) as error:
                return graded_to_line(not_laid(task.unit, error)), None

    def transition(self, key: str, start: str, finish: str, **_: object) -> None:
        """Called by Dask. Nobody waits for it any more: the coordinator was stopped, or is gone."""
        if finish == "cancelled":
            with self._lock:
                process = self._running.pop(key, None)
                if process:
                    process.interrupt()

    def teardown(self, worker: Worker) -> None:
        """Called by Dask, at the worker's end."""
        for process in self._processes:
            process.interrupt()

    @contextlib.contextmanager
    def _known(self, key: str) -> Iterator[None]:
        with self._lock:
            self._running[key] = None
        try:
            yield
        finally:
            with self._lock:
                self._running.pop(key, None)

    def _graded(self, key: str, task: Task, home: bytes, folder: Path) -> Answer:
        recording = folder / "evidence" / "recording.mcap"
        here = replace(task, home=str(unpack(home, folder)), evidence=str(recording))
        process = self._process()
        with self._lock:
            if key in self._running:
                self._running[key] = process
        graded = process.grade(here) if key in self._running else _called_off(task)
        if key not in self._running:
            process.close()  # it was interrupted, and must not be given another task
        return graded_to_line(graded), evidence_of(recording)

    def _process(self) -> GradingProcess:
        """This thread's: the kernel ends it with the thread that started it."""
        if not hasattr(self._own, "process"):
            self._own.process = GradingProcess()
            self._processes.append(self._own.process)
        process: GradingProcess = self._own.process
        return process


def _called_off(task: Task) -> Graded:
    return not_laid(task.unit, StorageError("The grading was called off."))


def _gate() -> Path:
    return cache_dir(os.environ) / "cluster" / host()


@contextlib.contextmanager
def _folder(scratch: Path) -> Iterator[Path]:
    """In the worker's own folder, which Dask removes when the worker was killed."""
    try:
        folder = Path(tempfile.mkdtemp(prefix="grading-", dir=scratch))
    except OSError as error:
        raise StorageError(f"{host()} has no room for a submission: {error}.", "Make room there.") from error
    try:
        yield folder
    except OSError as error:
        raise StorageError(f"{host()} cannot keep a submission: {error}.", "Make room there.") from error
    finally:
        wipe(folder)
