"""Plays a mystery on the learner's own ROS: starts its nodes, tells when they are up, ends them."""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
import select
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping
from pathlib import Path
from types import TracebackType
from typing import IO

import course
from course.errors import OurFault, UsageError

_READY = "ready"
START_TIME = 30.0
_END_TIME = 2.5
_LOG_LINES = 12
# How the learner's other programs talk; nothing else of their environment reaches the nodes.
TALK = (
    "ROS_DOMAIN_ID",
    "ROS_AUTOMATIC_DISCOVERY_RANGE",
    "ROS_STATIC_PEERS",
    "ROS_LOCALHOST_ONLY",
    "RMW_IMPLEMENTATION",
    "FASTRTPS_DEFAULT_PROFILES_FILE",
    "FASTDDS_DEFAULT_PROFILES_FILE",
    "FASTDDS_BUILTIN_TRANSPORTS",
    "CYCLONEDDS_URI",
)


def player_command() -> tuple[str, ...]:
    return (sys.executable, "-m", "course.arena.player")


def job_line(file: Path, exercise: str, seed: int, acts: Path | None) -> str:
    """What the player reads first; see `player.PlayJob`, which needs ROS to be imported."""
    job = {"file": str(file), "exercise": exercise, "seed": seed, "acts": str(acts) if acts else None}
    return json.dumps(job) + "\n"


def own_path(environment: Mapping[str, str]) -> str:
    """PYTHONPATH with this very course first."""
    parts = (str(Path(course.__file__).parents[1]), environment.get("PYTHONPATH"))
    return os.pathsep.join(part for part in parts if part)


class Playing:
    """A mystery's nodes between entering and leaving the context; entering waits until all are up.

    Raises OurFault when they do not come up.
    """

    def __init__(self, job: str, environment: Mapping[str, str], lock: IO[str]) -> None:
        self._job = job
        self._environment = environment
        self._lock = lock
        self._stack: contextlib.ExitStack
        self._process: subprocess.Popen[bytes]

    def __enter__(self) -> Playing:
        with contextlib.ExitStack() as stack:
            self._log = stack.enter_context(tempfile.TemporaryFile())
            logs = stack.enter_context(tempfile.TemporaryDirectory(prefix="ros2course-play-"))
            self._process = self._start(logs)
            stack.callback(self._end)
            self._await_ready()
            self._stack = stack.pop_all()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._stack.close()

    def wait(self) -> None:
        """Until the nodes end by themselves, which is a fault. Ctrl+C ends the waiting."""
        self._process.wait()
        raise self._fault("The mystery's nodes ended by themselves")

    def _start(self, logs: str) -> subprocess.Popen[bytes]:
        environment = {
            **self._environment,
            "PYTHONPATH": own_path(self._environment),
            "ROS_LOG_DIR": logs,
            "PYTHONDONTWRITEBYTECODE": "1",
        }
        return subprocess.Popen(
            player_command(),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._log,
            env=environment,
            cwd="/",
            # Ctrl+C at the terminal is for us; we end the nodes in order.
            start_new_session=True,
            # The lock is free when we and the nodes have ended, whichever is the last.
            pass_fds=(self._lock.fileno(),),
        )

    def _await_ready(self) -> None:
        assert self._process.stdin and self._process.stdout
        with contextlib.suppress(BrokenPipeError):
            self._process.stdin.write(self._job.encode())
            self._process.stdin.flush()
        deadline = time.monotonic() + START_TIME
        said = b""
        while _READY.encode() not in said.split(b"\n"):
            left = max(0.0, deadline - time.monotonic())
            if not select.select([self._process.stdout], [], [], left)[0]:
                raise self._fault(f"The mystery's nodes were not up within {START_TIME:.0f} s")
            data = os.read(self._process.stdout.fileno(), 4096)
            if not data:
                self._process.wait()
                raise self._fault("The mystery's nodes could not be started")
            said += data

    def _end(self) -> None:
        assert self._process.stdin and self._process.stdout
        with contextlib.suppress(OSError):
            self._process.stdin.close()  # tells it that we are done
        try:
            self._process.wait(_END_TIME)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._process.stdout.close()

    def _fault(self, what: str) -> OurFault:
        self._log.seek(0)
        lines = self._log.read().decode(errors="replace").splitlines()[-_LOG_LINES:]
        told = f": {' | '.join(lines)}" if lines else ""
        return OurFault(f"{what}{told}", "This is the course's error, not yours. Try again.")


@contextlib.contextmanager
def only_once(file: Path, exercise: str) -> Iterator[IO[str]]:
    """Hold the lock file for as long as the mystery is played. Raises UsageError when it is held."""
    file.parent.mkdir(parents=True, exist_ok=True)
    with file.open("a", encoding="utf-8") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            advice = "Go to the terminal it was started in; Ctrl+C ends it there."
            raise UsageError(f"{exercise} is running already.", advice) from None
        yield lock
