"""The parent's side of recording processes: fork one early, give it the task, await the recording.

They are forks of one process, which loads everything before there is anything to record. However one ends
(crash, hang, Ctrl+C here), everything that it started has ended afterward.
"""

from __future__ import annotations

import contextlib
import os
import select
import signal
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import IO

from course import isolation
from course.child import own_path
from course.errors import CourseError, DamagedData, OurFault, StorageError
from course.files import wipe
from course.grading.protocol import Fork, RecordingOutcome, RecordingTask, read_message
from course.isolation import Level
from course.isolation.isolation_plan import SCRATCH
from course.isolation.launcher import socket_pair
from course.isolation.levels import KNOWN, Isolation, forget
from course.isolation.none import end, nothing_left
from course.model import codec
from course.model.feedback import Feedback
from course.model.result import Doubt
from course.rosenv import find_ros, node_environment, prepare

_CLOSE_GRACE = 3.0
_START_TIME = 30.0
_LOG_LINES = 15
_PROCESS = "course.grading.recording_process"


class ForkServer:
    """The process that recording processes are forked from. Close it; it also ends with its owner."""

    def __init__(self) -> None:
        self._started: tuple[subprocess.Popen[bytes], socket.socket] | None = None
        self.log = os.fdopen(os.memfd_create("log"), "w+b")  # its error output

    def start(self, environment: Mapping[str, str]) -> None:
        """Start the process, which loads everything, if it is not running. Forks get other environments."""
        if self._started is not None and self._started[0].poll() is not None:
            self._stop()  # somebody killed it
        if self._started is None:
            ours, theirs = socket_pair()
            ours.settimeout(_START_TIME)
            with theirs:
                process = subprocess.Popen(
                    [sys.executable, "-m", _PROCESS, str(theirs.fileno())],
                    stdin=subprocess.DEVNULL,
                    stdout=self.log,
                    stderr=self.log,
                    env={**environment, "PYTHONPATH": own_path(environment)},
                    cwd="/",
                    pass_fds=(theirs.fileno(),),
                    start_new_session=True,
                )
            self._started = process, ours

    def start_early(self) -> None:
        """Start it before we know whether ROS is installed; if it is not, grading reports that."""
        with contextlib.suppress(CourseError):
            prepare(ros := find_ros())
            self.start(node_environment(ros))

    @contextlib.contextmanager
    def forked(self, fork: Fork, descriptors: Sequence[int]) -> Iterator[None]:
        """A recording process, which is killed at the end. It starts later if modules are still loading.

        descriptors: its input, its error output, and those that `recording_process` lists. Raises OurFault.
        """
        self.start(fork.environment)
        assert self._started is not None
        link = self._started[1]
        try:
            socket.send_fds(link, [codec.to_json(fork)], list(descriptors))
        except OSError as error:
            raise OurFault("recording processes cannot be started") from error
        try:
            yield
        finally:
            self._end(link)

    def _end(self, link: socket.socket) -> None:
        try:
            answer, found, _, _ = socket.recv_fds(link, 100, 1)
        except OSError:
            answer, found = b"", []
        if not answer:
            self._stop()
        for process in found:
            with contextlib.suppress(ProcessLookupError):
                signal.pidfd_send_signal(process, signal.SIGKILL)
            select.select([process], [], [], _CLOSE_GRACE)
            os.close(process)

    def close(self) -> None:
        """End the process, if it is running."""
        self._stop()
        self.log.close()

    def _stop(self) -> None:
        started, self._started = self._started, None
        if started is not None:
            started[1].close()
            end(started[0])


class Supervisor:
    """Owns one recording process between entering and leaving its context.

    fork_server: what it is forked from.
    recording: the file that it writes. It has no name, so nobody else finds it, and it never outlives us.
    environment: the process's. judged: the recording that a run adds notes to when it looks for a cause.
    """

    def __init__(
        self,
        where: Isolation,
        environment: Mapping[str, str],
        fork_server: ForkServer,
        judged: IO[bytes] | None = None,
    ) -> None:
        self._where = where
        self._fork_server = fork_server
        self._judged = judged
        self.environment = environment
        self._tasks: int
        self.recording: IO[bytes]
        self._results: int
        self._folder: str
        self._running = False  # whether the submission's programs have been started
        self._stack: contextlib.ExitStack

    def __enter__(self) -> Supervisor:
        with contextlib.ExitStack() as stack:
            try:
                self._folder = stack.enter_context(self._scratch())
                self.recording = stack.enter_context(tempfile.TemporaryFile())
                self._log = stack.enter_context(tempfile.TemporaryFile("w+b"))
            except OSError as error:
                what = f"No temporary file can be created in {tempfile.gettempdir()}: {error.strerror}."
                raise StorageError(what, "Make room there, or name another folder in TMPDIR.") from error
            self._start(stack)
            self._stack = stack.pop_all()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._stack.close()

    @contextlib.contextmanager
    def _scratch(self) -> Iterator[str]:
        """Provide the folder for the learner's programs; afterward, end everything that was started for it.

        In namespaces, the kernel does both, whatever happens to us.
        """
        if self._where.level is not Level.DOMAIN:
            yield str(SCRATCH)
            return
        folder = tempfile.mkdtemp(prefix="ros2course-")
        try:
            with nothing_left():
                yield folder
        finally:
            wipe(Path(folder))

    def _start(self, stack: contextlib.ExitStack) -> None:
        holder = None
        if self._where.plan is not None:
            try:
                holder = stack.enter_context(isolation.ISOLATION.hold(self._where.plan)).pid
            except OurFault:
                forget(KNOWN)  # perhaps this machine no longer allows what it allowed before
                raise
        with contextlib.ExitStack() as theirs:
            self._results, write_end = _pipe(stack, theirs)
            read_end, self._tasks = _pipe(theirs, stack)
            judged = (self._judged.fileno(),) if self._judged else ()
            given = (read_end, self._log.fileno(), write_end, self.recording.fileno(), *judged)
            fork = Fork(self._own_environment(), self._folder, holder)
            stack.enter_context(self._fork_server.forked(fork, given))

    def record(
        self, task: RecordingTask, time_limit: float, on_progress: Callable[[str], None]
    ) -> RecordingOutcome:
        """Send the task and read until the outcome. Errors of the process become an outcome with a fault."""
        try:
            rest = codec.to_json(task) + b"\n"
            while rest:
                rest = rest[os.write(self._tasks, rest) :]
        except BrokenPipeError:
            forget(KNOWN)  # perhaps this machine no longer allows what it allowed before
            return self._fault("The recording process did not start.")
        return self._await_outcome(time_limit, on_progress)

    def _await_outcome(self, time_limit: float, on_progress: Callable[[str], None]) -> RecordingOutcome:
        deadline = time.monotonic() + time_limit + _START_TIME
        buffer = b""
        while True:
            ready, _, _ = select.select([self._results], [], [], max(0.0, deadline - time.monotonic()))
            if not ready:
                return self._fault(f"The recording process did not finish within {time_limit:.0f} s.")
            data = os.read(self._results, 65536)
            if not data:
                forget(KNOWN)
                return self._fault("The recording process ended without a recording.")
            *lines, buffer = (buffer + data).split(b"\n")
            for line in lines:
                try:
                    message = read_message(line)
                except DamagedData:
                    return self._fault("The recording process sent something other than our protocol.")
                if isinstance(message, RecordingOutcome):
                    return message
                self._running = self._running or message.running
                on_progress(message.text)

    def _fault(self, what: str) -> RecordingOutcome:
        tail = (*_last_lines(self._fork_server.log), *_last_lines(self._log))[-_LOG_LINES:]
        advice = "This is the course's error, not yours. The attempt does not count. Try again."
        doubt = Doubt.SPOILT if self._running else None
        return RecordingOutcome(fault=Feedback(summary=what, advice=advice, details=tail), doubt=doubt)

    def _own_environment(self) -> dict[str, str]:
        return {
            **self.environment,
            **self._where.environment,
            "ROS_LOG_DIR": f"{self._folder}/ros-log",  # not the learner's ~/.ros
            "PYTHONPATH": own_path(self.environment),
        }


def _last_lines(log: IO[bytes]) -> list[str]:
    size = os.fstat(log.fileno()).st_size
    return os.pread(log.fileno(), 8192, max(0, size - 8192)).decode(errors="replace").splitlines()


def _pipe(reading: contextlib.ExitStack, writing: contextlib.ExitStack) -> tuple[int, int]:
    """The ends of a new pipe, each of which its stack closes."""
    ends = os.pipe()
    for number, stack in zip(ends, (reading, writing), strict=True):
        stack.callback(os.close, number)
    return ends
