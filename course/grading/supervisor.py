"""The parent's side of a recording process: start it early, give it the task, await the recording.

The process is started before the task is known, so that it loads while packages are built.
However it ends (crash, hang, Ctrl+C here), everything below it has ended afterwards.
"""

from __future__ import annotations

import contextlib
import os
import select
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from types import TracebackType
from typing import IO

import course
from course.errors import DamagedData, StorageError
from course.files import wipe
from course.grading.protocol import RecordingOutcome, RecordingTask, read_message
from course.isolation import Level, start
from course.isolation.isolation_plan import SCRATCH, IsolatedProcess
from course.isolation.levels import KNOWN, Isolation, forget
from course.isolation.none import nothing_left
from course.model import codec
from course.model.feedback import Feedback
from course.model.result import Doubt

_CLOSE_GRACE = 3.0
_START_TIME = 30.0
_LOG_LINES = 15
_PROCESS = "course.grading.recording_process"


class Supervisor:
    """Owns one recording process between entering and leaving its context.

    recording: the file that it writes. It has no name: it is gone however we end, and nobody else finds it.
    environment: its own. judged: the recording that a run adds to when it looks for a cause.
    """

    def __init__(
        self, where: Isolation, environment: Mapping[str, str], judged: IO[bytes] | None = None
    ) -> None:
        self._where = where
        self._judged = judged
        self.environment = environment
        self._process: subprocess.Popen[bytes]
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
                self._log = stack.enter_context(tempfile.TemporaryFile("w+", errors="replace"))
            except OSError as error:
                what = f"No temporary file can be made in {tempfile.gettempdir()}: {error.strerror}."
                raise StorageError(what, "Make room there, or name another folder in TMPDIR.") from error
            self._results, write_end = os.pipe()
            stack.callback(os.close, self._results)
            try:
                self._process = stack.enter_context(self._start(write_end)).process
            finally:
                os.close(write_end)
            stack.callback(self._end)
            self._stack = stack.pop_all()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._stack.close()

    @contextlib.contextmanager
    def _scratch(self) -> Iterator[str]:
        """The folder for the learner's programs, and the end of all that was started for it.

        In namespaces of its own the kernel does both, whatever happens to us.
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

    def _start(self, write_end: int) -> contextlib.AbstractContextManager[IsolatedProcess]:
        """In its own session, so that Ctrl+C reaches only us, and we end the process in order."""
        descriptors = (write_end, self.recording.fileno())
        judged = (self._judged.fileno(),) if self._judged else ()
        return start(
            self._where.plan,
            [sys.executable, "-m", _PROCESS, *map(str, descriptors), self._folder, *map(str, judged)],
            stdin=subprocess.PIPE,
            stdout=self._log,
            stderr=self._log,
            env=self._own_environment(),
            cwd="/",
            pass_fds=(*descriptors, *judged),
        )

    def _end(self) -> None:
        with contextlib.suppress(OSError):
            if self._process.stdin:
                self._process.stdin.close()  # tells it that we are gone
        try:
            self._process.wait(_CLOSE_GRACE)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()

    def record(
        self, task: RecordingTask, time_limit: float, on_progress: Callable[[str], None]
    ) -> RecordingOutcome:
        """Send the task and read until the outcome; faults of the process become one."""
        try:
            assert self._process.stdin is not None
            self._process.stdin.write(codec.to_json(task) + b"\n")
            self._process.stdin.flush()
        except BrokenPipeError:
            forget(KNOWN)  # perhaps this machine does not allow any more what it did
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
                how = self._how_it_ended()
                return self._fault(f"The recording process ended without a recording ({how}).")
            *lines, buffer = (buffer + data).split(b"\n")
            for line in lines:
                try:
                    message = read_message(line)
                except DamagedData:
                    return self._fault("The recording process did not speak our language.")
                if isinstance(message, RecordingOutcome):
                    return message
                self._running = self._running or message.running
                on_progress(message.text)

    def _how_it_ended(self) -> str:
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._process.wait(_CLOSE_GRACE)
        code = self._process.poll()
        return "still running" if code is None else f"signal {-code}" if code < 0 else f"exit code {code}"

    def _fault(self, what: str) -> RecordingOutcome:
        self._log.seek(0, os.SEEK_END)
        self._log.seek(max(0, self._log.tell() - 8192))
        tail = tuple(self._log.read().splitlines()[-_LOG_LINES:])
        advice = "This is the course's error, not yours. The attempt does not count. Try again."
        doubt = Doubt.SPOILT if self._running else None
        return RecordingOutcome(fault=Feedback(summary=what, advice=advice, details=tail), doubt=doubt)

    def _own_environment(self) -> dict[str, str]:
        return {
            **self.environment,
            **self._where.environment,
            "ROS_LOG_DIR": f"{self._folder}/ros-log",  # not the learner's ~/.ros
            "PYTHONPATH": os.pathsep.join(
                part
                for part in (str(Path(course.__file__).parents[1]), self.environment.get("PYTHONPATH"))
                if part
            ),
        }
