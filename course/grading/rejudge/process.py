"""One of the processes that judge recordings, as its parent sees it."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import tempfile
from collections import deque
from collections.abc import Iterable
from pathlib import Path
from typing import Generic

import course
from course.content import Exercise
from course.errors import OurFault
from course.grading.rejudge.model import MOST_TIME, Key, Portion, Stored, portion_to_line

_WORKER = "course.grading.rejudge.worker"
_CHUNK = 1 << 16
_LOG = 2000
# No preparation for ROS by the wheels, which takes longer than ten recordings; no plugins but ours.
_QUICK = {"_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1", "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}


class Judges(Generic[Key]):
    """A process. waiting: what it has been given and has not answered. answers: where it does."""

    def __init__(self) -> None:
        self.waiting: deque[Stored[Key]] = deque()
        self._ready = False
        self._rest = b""
        with contextlib.ExitStack() as stack:
            self._log = stack.enter_context(tempfile.TemporaryFile("w+", errors="replace"))
            self.answers, theirs = os.pipe()
            stack.callback(os.close, self.answers)
            try:
                self._process = stack.enter_context(start_judging(_WORKER, theirs, self._log.fileno()))
            finally:
                os.close(theirs)
            stack.callback(self._process.kill)
            self._stack = stack.pop_all()

    def take(self, portion: list[Stored[Key]], known: Iterable[Exercise] = ()) -> None:
        """Recordings whose checks are in one module. known: further exercises that may follow."""
        self.waiting.extend(portion)
        grader = portion[0].exercise.grader
        exercises = {one.id: one for one in known if one.grader == grader}
        exercises |= {stored.exercise.id: stored.exercise for stored in portion}
        looks_at = {name: (*one.files, *one.looks_at) for name, one in exercises.items()}
        files = [(stored.exercise.id, str(stored.file)) for stored in portion]
        line = portion_to_line(Portion(str(grader), looks_at, files))
        assert self._process.stdin is not None
        with contextlib.suppress(BrokenPipeError):  # it is read that it ended
            self._process.stdin.write(line + "\n")
            self._process.stdin.flush()

    def read(self) -> list[str] | None:
        """What it answered since; None when it has ended."""
        data = os.read(self.answers, _CHUNK)
        if not data:
            return None
        *lines, self._rest = (self._rest + data).split(b"\n")
        if lines and not self._ready:
            self._ready = True
            del lines[0]
        return [line.decode() for line in lines]

    def how_it_ended(self) -> str:
        """Raises OurFault when it never began."""
        code = self._process.wait()
        if not self._ready:
            self._log.seek(0)
            raise OurFault(f"recordings cannot be judged here: {self._log.read()[-_LOG:].strip()}")
        if code == -signal.SIGALRM:
            return f"Judging it took more than {MOST_TIME} s."
        how = f"by signal {-code}" if code < 0 else f"with {code}"
        return f"The process that judged it was ended {how}."

    def close(self) -> None:
        """End it; more than once does no harm."""
        with contextlib.suppress(BrokenPipeError):
            self._stack.close()


def start_judging(module: str, answers: int, log: int) -> subprocess.Popen[str]:
    """Run a module that judges recordings. answers, log: descriptors; the former is its argument."""
    return subprocess.Popen(
        [sys.executable, "-m", module, str(answers)],
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        stderr=log,
        env=_environment(),
        cwd="/",
        pass_fds=(answers,),
        start_new_session=True,  # Ctrl+C at the terminal is for us
        text=True,
    )


def _environment() -> dict[str, str]:
    """Ours, but nothing of it tells pytest what to do."""
    own = str(Path(course.__file__).parents[1])
    path = os.pathsep.join(part for part in (own, os.environ.get("PYTHONPATH")) if part)
    others = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST_")}
    return {**others, **_QUICK, "PYTHONPATH": path}
