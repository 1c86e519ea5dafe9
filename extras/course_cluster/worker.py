"""What runs on a Dask worker: each grading in a separate process and a temporary folder."""

from __future__ import annotations

import contextlib
import os
import tempfile
import threading
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from distributed import Worker, WorkerPlugin, get_worker
from distributed.utils import sync

from course.batch.gradings import GRADINGS, Graded, GradingTask
from course.batch.pool import Worker as Process
from course.batch.run import default_jobs, not_laid
from course.errors import StorageError
from course.files import locked, wipe
from course.home.opening import Refused
from course.model import codec, replace
from course.rosenv import cache_dir
from course_cluster.fitness import Wanted, engine_digest, host, unfit
from course_cluster.parcel import evidence_of, unpack

_NAME = "ros2course"
_adding = threading.Lock()

# The grading, as a line of JSON, and its recording, if there is one.
Answer = tuple[bytes, bytes | None]


def look(asked: Mapping[str, Any]) -> tuple[str, tuple[str, str] | None]:
    """A Dask task: the name of this machine, and why it may not grade (see Unfit). asked: a Wanted.

    If it may, it offers Dask a resource for as many gradings as its processors can handle.
    """
    wanted, worker = Wanted(**asked), get_worker()
    problem = unfit(wanted, _plugin(worker).engine)
    if problem:
        return host(), (problem.why, problem.advice)
    gradings = min(worker.state.nthreads, default_jobs())
    sync(worker.loop, worker.set_resources, **{wanted.resource: gradings})
    return host(), None


def grade(line: bytes, home: bytes, alone: bool) -> Answer:
    """A Dask task. line: the course's task, whose paths are the coordinator's.

    home: as `parcel.pack` made it. alone: with no other grading on this machine at the same time.
    """
    worker = get_worker()
    key, scratch = worker.get_current_task(), Path(worker.local_directory)
    return _plugin(worker).grade(key, codec.from_json(line, GradingTask, "the task"), home, alone, scratch)


def _plugin(worker: Worker) -> GradingPlugin:
    with _adding:
        if _NAME not in worker.plugins:
            sync(worker.loop, worker.plugin_add, plugin=GradingPlugin(), name=_NAME)
    plugin: GradingPlugin = worker.plugins[_NAME]
    return plugin


class GradingPlugin(WorkerPlugin):  # type: ignore[misc]  # Dask's types are not checked
    """Each of the worker's threads has a grading process, which ends with the thread."""

    def __init__(self) -> None:
        self.engine = engine_digest()  # of the imported code; its files may be replaced at any time
        self._own = threading.local()
        self._lock = threading.Lock()
        self._running: dict[str, Process[GradingTask, Graded] | None] = {}
        self._processes: list[Process[GradingTask, Graded]] = []

    def grade(self, key: str, task: GradingTask, home: bytes, alone: bool, scratch: Path) -> Answer:
        with self._known(key), turn(_gate(), alone=alone):
            try:
                with _folder(scratch) as folder:
                    return self._graded(key, task, home, folder)
            except (Refused, StorageError) as error:
                return codec.to_json(not_laid(task.unit, error)), None

    def transition(self, key: str, start: str, finish: str, **_: object) -> None:
        """Called by Dask when nobody waits for a task any more, because the coordinator ended."""
        if finish == "cancelled":
            with self._lock:
                process = self._running.pop(key, None)
                if process:
                    process.interrupt()

    def teardown(self, worker: Worker) -> None:
        """Called by Dask when the worker ends."""
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

    def _graded(self, key: str, task: GradingTask, home: bytes, folder: Path) -> Answer:
        recording = folder / "evidence" / "recording.mcap"
        here = replace(task, home=str(unpack(home, folder)), evidence=str(recording))
        process = self._process()
        with self._lock:
            if key in self._running:
                self._running[key] = process
        graded = process.do(here) if key in self._running else _called_off(task)
        if key not in self._running:
            process.close()  # it was interrupted, and must not get another task
        return codec.to_json(graded), evidence_of(recording)

    def _process(self) -> Process[GradingTask, Graded]:
        """This thread's process. The kernel ends it with the thread that started it."""
        if not hasattr(self._own, "process"):
            self._own.process = Process(GRADINGS)
            self._processes.append(self._own.process)
        process: Process[GradingTask, Graded] = self._own.process
        return process


def _called_off(task: GradingTask) -> Graded:
    return not_laid(task.unit, StorageError("The grading was canceled."))


def _gate() -> Path:
    return cache_dir(os.environ) / "cluster" / host()


@contextlib.contextmanager
def turn(gate: Path, *, alone: bool) -> Iterator[None]:
    """Wait until this grading may run: several run together, or one alone.

    gate: a file that all workers of the machine share. While one waits to run alone, no others start. A
    process that dies releases it.
    """
    with contextlib.ExitStack() as stack:
        with locked(gate.with_name(f"{gate.name}.next")):
            stack.enter_context(locked(gate, shared=not alone))
        yield


@contextlib.contextmanager
def _folder(scratch: Path) -> Iterator[Path]:
    """A temporary folder in the worker's own one, which Dask removes if the worker is killed."""
    try:
        folder = Path(tempfile.mkdtemp(prefix="grading-", dir=scratch))
    except OSError as error:
        raise StorageError(
            f"{host()} has no space for a submission: {error}.", "Free space there."
        ) from error
    try:
        yield folder
    except OSError as error:
        raise StorageError(f"{host()} cannot store a submission: {error}.", "Free space there.") from error
    finally:
        wipe(folder)
