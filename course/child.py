"""One of our own processes, which does one task after another: the parent's side and the process's side.

Both sides send lines of JSON. Tasks go to the standard input of `python -m MODULE DESCRIPTOR`; answers come
through that descriptor, a separate pipe, so nothing that the process prints is taken for an answer.

Three of our programs are started differently. `course.arena.lateness_program` measures this machine, so it
starts in milliseconds and imports none of our modules. Probes and the nodes of a mystery run among the
learner's programs, within the same limits: they cannot be trusted, and their output is part of the recording.
"""

from __future__ import annotations

import contextlib
import ctypes
import os
import select
import signal
import subprocess
import sys
import threading
import time
from collections import deque
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import IO, NoReturn, TypeVar

import course
from course.errors import DamagedData
from course.model import codec

Task = TypeVar("Task")
Tell = Callable[[object], None]
_CHUNK = 1 << 16
LONGEST_LINE = 1 << 26
_PR_SET_PDEATHSIG = 1


def own_path(environment: Mapping[str, str]) -> str:
    """PYTHONPATH, with the folder of the running engine first."""
    parts = (str(Path(course.__file__).parents[1]), environment.get("PYTHONPATH"))
    return os.pathsep.join(part for part in parts if part)


class Child:
    """Starts the process; call `close` at the end. answers: the descriptor to wait for.

    log: where it writes its errors; None for our stderr. environment: None for ours. folder: where it runs,
    and looks for modules first.
    """

    def __init__(
        self,
        module: str,
        *,
        log: IO[str] | None = None,
        environment: Mapping[str, str] | None = None,
        folder: str | None = None,
    ) -> None:
        environment = os.environ if environment is None else environment
        self._lines: deque[bytes] = deque()
        self._rest = b""
        self.answers, theirs = os.pipe()
        try:
            self.process = subprocess.Popen(
                [sys.executable, "-m", module, str(theirs)],
                stdin=subprocess.PIPE,
                stdout=subprocess.DEVNULL,
                stderr=log,
                env={**environment, "PYTHONPATH": own_path(environment)},
                cwd=folder,
                pass_fds=(theirs,),
                # Ctrl+C at the terminal is for us; we end the process in order.
                start_new_session=True,
            )
        except BaseException:
            os.close(self.answers)
            raise
        finally:
            os.close(theirs)

    def tell(self, task: object) -> None:
        """Send a task. Does nothing if the process has ended; `read` reports that."""
        assert self.process.stdin is not None
        with contextlib.suppress(BrokenPipeError):
            self.process.stdin.write(codec.to_json(task) + b"\n")
            self.process.stdin.flush()

    def read(self) -> list[bytes] | None:
        """Wait for output and return the new complete lines; None when the process has ended.

        Raises DamagedData for a line that is far too long.
        """
        data = os.read(self.answers, _CHUNK)
        if not data:
            return None
        *lines, self._rest = (self._rest + data).split(b"\n")
        if len(self._rest) > LONGEST_LINE:
            self._rest = b""
            raise DamagedData("Another process sent a line that is far too long.")
        return lines

    def readline(self, timeout: float) -> bytes | None:
        """The next answer; None if the process has ended without one. Raises TimeoutError, DamagedData."""
        deadline = time.monotonic() + timeout
        while not self._lines:
            if not select.select([self.answers], [], [], max(0.0, deadline - time.monotonic()))[0]:
                raise TimeoutError
            lines = self.read()
            if lines is None:
                return None
            self._lines.extend(lines)
        return self._lines.popleft()

    def close(self, patience: float = 0.0) -> None:
        """Tell the process that no more tasks follow; kill it if it still runs after `patience` seconds."""
        if self.process.stdin:
            with contextlib.suppress(OSError):
                self.process.stdin.close()
        try:
            self.process.wait(patience)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        os.close(self.answers)


def answer_tasks(
    kind: type[Task], answer: Callable[[Task, Tell], object], *, at_parents_end: int = signal.SIGKILL
) -> None:
    """The process's loop: do one task after another, until the parent is gone or says to end.

    kind: the type of the tasks. answer: returns what to send back; it may send more before that, with its
    second argument, from any thread. at_parents_end: the signal for this process when its parent is gone.
    """
    for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        signal.signal(number, _call_off)
    end_with_parent(at_parents_end)
    one_at_a_time = threading.Lock()
    with (
        contextlib.suppress(KeyboardInterrupt, BrokenPipeError),
        os.fdopen(int(sys.argv[1]), "wb") as answers,
    ):

        def tell(message: object) -> None:
            with one_at_a_time:
                answers.write(codec.to_json(message) + b"\n")
                answers.flush()

        for line in sys.stdin.buffer:
            tell(answer(codec.from_json(line, kind, "the task"), tell))


def end_with_parent(number: int = signal.SIGKILL) -> None:
    """Have the kernel send us this signal when the thread that started us ends, for whatever reason."""
    ctypes.CDLL(None, use_errno=True).prctl(_PR_SET_PDEATHSIG, number, 0, 0, 0)


def _call_off(number: int, frame: object) -> NoReturn:
    for ending in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        signal.signal(ending, signal.SIG_IGN)  # nothing interrupts the cleanup
    raise KeyboardInterrupt
