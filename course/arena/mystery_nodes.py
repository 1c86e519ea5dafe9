"""Starts the nodes of a mystery, on the learner's own ROS or in an arena: `mystery_program` runs them."""

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
from typing import IO

from course.arena.mystery_module import READY, MysteryJob
from course.arena.process import Process
from course.child import own_path
from course.errors import OurFault, UsageError
from course.evidence.acts import MYSTERY
from course.evidence.timeline import Timeline
from course.files import locked
from course.isolation import start
from course.model import codec
from course.model.events import OutputLine

COMMAND = (sys.executable, "-m", "course.arena.mystery_program")
_START_TIME = 30.0
_END_TIME = 2.5
_LOG_LINES = 12
# The arena keeps its own values of these.
_ARENAS = frozenset({"HOME", "TMPDIR", "ROS_LOG_DIR", "TERM"})
# How the learner's other programs communicate; the nodes get nothing else from their environment.
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


class MysteryNodes:
    """A mystery's nodes while they are up."""

    def __init__(self, process: subprocess.Popen[bytes], log: IO[bytes]) -> None:
        self._process = process
        self._log = log

    def wait(self) -> None:
        """Wait until the nodes end by themselves, which is a fault. Ctrl+C ends the wait."""
        self._process.wait()
        raise self._fault("The mystery's nodes ended by themselves")

    def await_ready(self, job: MysteryJob) -> None:
        assert self._process.stdin and self._process.stdout
        with contextlib.suppress(BrokenPipeError):
            self._process.stdin.write(codec.to_json(job) + b"\n")
            self._process.stdin.flush()
        deadline = time.monotonic() + _START_TIME
        said = b""
        while READY.encode() not in said.split(b"\n"):
            left = max(0.0, deadline - time.monotonic())
            if not select.select([self._process.stdout], [], [], left)[0]:
                raise self._fault(f"The mystery's nodes were not up within {_START_TIME:.0f} s")
            data = os.read(self._process.stdout.fileno(), 4096)
            if not data:
                self._process.wait()
                raise self._fault("The mystery's nodes could not be started")
            said += data

    def end(self) -> None:
        """Let the nodes shut down properly. The process that started them kills the rest."""
        assert self._process.stdin
        with contextlib.suppress(OSError):
            self._process.stdin.close()  # tells it that we are done
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._process.wait(_END_TIME)

    def _fault(self, what: str) -> OurFault:
        self._log.seek(0)
        lines = self._log.read().decode(errors="replace").splitlines()[-_LOG_LINES:]
        told = f": {' | '.join(lines)}" if lines else ""
        return OurFault(f"{what}{told}", "This is the course's error, not yours. Try again.")


@contextlib.contextmanager
def mystery_nodes(job: MysteryJob, environment: Mapping[str, str], lock: int) -> Iterator[MysteryNodes]:
    """A mystery's nodes on the learner's own ROS: all are up while the context lasts.

    lock: see `only_once`; released when both we and the nodes have ended. Raises OurFault if the nodes do
    not come up.
    """
    with contextlib.ExitStack() as stack:
        log = stack.enter_context(tempfile.TemporaryFile())
        logs = stack.enter_context(tempfile.TemporaryDirectory(prefix="ros2course-play-"))
        settings = {"ROS_LOG_DIR": logs, "PYTHONDONTWRITEBYTECODE": "1"}
        started = stack.enter_context(
            start(
                None,
                COMMAND,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=log,
                env={**_with_this_course(environment), **settings},
                cwd="/",
                pass_fds=(lock,),
            )
        )
        nodes = MysteryNodes(started.process, log)
        stack.callback(nodes.end)
        nodes.await_ready(job)
        yield nodes


def start_in_arena(
    file: Path,
    seed: int | None,
    timeline: Timeline,
    start_ours: Callable[[tuple[str, ...], Mapping[str, str]], Process],
) -> Process:
    """Start a mystery's nodes alongside the learner's programs, but on the course's own ROS.

    start_ours: starts a command with an environment under the name MYSTERY. Raises OurFault if there is no
    seed, or the nodes do not come up.
    """
    if seed is None:
        raise OurFault(f"no seed was given to draw {file.stem} from")

    def printed() -> list[str]:
        return [event.text for event in timeline.of(OutputLine) if event.process == MYSTERY]

    process = start_ours(COMMAND, _with_this_course(our_environment()))
    process.type(codec.to_json(MysteryJob(str(file), file.stem, seed)).decode() + "\n")
    timeline.wait_until(lambda: READY in printed() or not process.running, _START_TIME)
    if READY not in printed():
        raise OurFault(f"the mystery's nodes did not come up: {' | '.join(printed()[-5:])}")
    return process


def our_environment() -> dict[str, str]:
    """This process's environment, for programs of the course that run alongside the learner's."""
    return {name: value for name, value in os.environ.items() if name not in _ARENAS}


def _with_this_course(environment: Mapping[str, str]) -> dict[str, str]:
    return {**environment, "PYTHONPATH": own_path(environment)}


@contextlib.contextmanager
def only_once(file: Path, exercise: str) -> Iterator[int]:
    """Hold the lock file while the mystery is being played. Raises UsageError if it is already held."""
    with contextlib.ExitStack() as stack:
        try:
            lock = stack.enter_context(locked(file, wait=False))
        except BlockingIOError:
            advice = "Go to the terminal it was started in; Ctrl+C ends it there."
            raise UsageError(f"{exercise} is already running.", advice) from None
        yield lock
