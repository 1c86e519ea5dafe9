"""The parent's side of a grading process: start it early, give it the job, await its verdict.

The process is started before the job is known, so that it loads while packages are built.
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

import course
from course.arena.containment import KNOWN, SCRATCH
from course.arena.enclosure import Enclosure
from course.arena.leftovers import nothing_left
from course.arena.remembered import forget
from course.errors import StorageError
from course.feedback import Feedback
from course.grading.channel import Judgement, read_message
from course.grading.job import Job, to_line

_CLOSE_GRACE = 3.0
_START_TIME = 30.0
_LOG_LINES = 15
_PROCESS = "course.grading.process"


class Supervisor:
    """Owns one grading process between entering and leaving its context."""

    def __init__(self, where: Enclosure, environment: Mapping[str, str]) -> None:
        self._where = where
        self._environment = environment
        self._process: subprocess.Popen[str]
        self._results: int
        self._folder: str
        self._stack: contextlib.ExitStack

    def __enter__(self) -> Supervisor:
        with contextlib.ExitStack() as stack:
            try:
                self._folder = stack.enter_context(self._scratch())
                # Unlinked at once, so it is gone however we end.
                self._log = stack.enter_context(tempfile.TemporaryFile("w+", errors="replace"))
            except OSError as error:
                what = f"No temporary file can be made in {tempfile.gettempdir()}: {error.strerror}."
                raise StorageError(what, "Make room there, or name another folder in TMPDIR.") from error
            self._results, write_end = os.pipe()
            stack.callback(os.close, self._results)
            try:
                self._process = self._start(write_end)
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
        if self._where.kind != "domain":
            yield str(SCRATCH)
            return
        folder = tempfile.mkdtemp(prefix="ros2course-")
        try:
            with nothing_left():
                yield folder
        finally:
            # Not shutil: a tree of a thousand folders in one another is too deep for it.
            subprocess.run(["rm", "-rf", "--", folder], check=False, stderr=subprocess.DEVNULL)

    def _start(self, write_end: int) -> subprocess.Popen[str]:
        return subprocess.Popen(
            [*self._where.prefix, sys.executable, "-m", _PROCESS, str(write_end), self._folder],
            stdin=subprocess.PIPE,
            stdout=self._log,
            stderr=self._log,
            env=self._own_environment(),
            cwd="/",
            pass_fds=(write_end,),
            # Ctrl+C at the terminal is for us alone; we end the process in order.
            start_new_session=True,
            text=True,
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

    def grade(self, job: Job, time_limit: float, on_progress: Callable[[str], None]) -> Judgement:
        """Send the job and read until the judgement; faults of the process become one."""
        try:
            assert self._process.stdin is not None
            self._process.stdin.write(to_line(job) + "\n")
            self._process.stdin.flush()
        except BrokenPipeError:
            forget(KNOWN)  # perhaps this machine does not allow any more what it did
            return self._fault("The grading process did not start.")
        return self._await_judgement(time_limit, on_progress)

    def _await_judgement(self, time_limit: float, on_progress: Callable[[str], None]) -> Judgement:
        deadline = time.monotonic() + time_limit + _START_TIME
        buffer = b""
        while True:
            ready, _, _ = select.select([self._results], [], [], max(0.0, deadline - time.monotonic()))
            if not ready:
                return self._fault(f"The grading process did not finish within {time_limit:.0f} s.")
            data = os.read(self._results, 65536)
            if not data:
                forget(KNOWN)
                return self._fault(f"The grading process ended without a verdict ({self._how_it_ended()}).")
            *lines, buffer = (buffer + data).split(b"\n")
            for line in lines:
                try:
                    message = read_message(line.decode())
                except (KeyError, ValueError):
                    return self._fault("The grading process did not speak our language.")
                if isinstance(message, Judgement):
                    return message
                on_progress(message)

    def _how_it_ended(self) -> str:
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._process.wait(_CLOSE_GRACE)
        code = self._process.poll()
        return "still running" if code is None else f"signal {-code}" if code < 0 else f"exit code {code}"

    def _fault(self, what: str) -> Judgement:
        self._log.seek(0, os.SEEK_END)
        self._log.seek(max(0, self._log.tell() - 8192))
        tail = tuple(self._log.read().splitlines()[-_LOG_LINES:])
        advice = "This is the course's error, not yours. The attempt does not count. Try again."
        return Judgement((), 0.0, Feedback(summary=what, advice=advice, details=tail))

    def _own_environment(self) -> dict[str, str]:
        return {
            **self._environment,
            **self._where.environment,
            "ROS_LOG_DIR": f"{self._folder}/ros-log",  # not the learner's ~/.ros
            "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",
            "PYTHONPATH": os.pathsep.join(
                part
                for part in (str(Path(course.__file__).parents[1]), self._environment.get("PYTHONPATH"))
                if part
            ),
        }
