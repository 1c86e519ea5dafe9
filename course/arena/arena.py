"""The arena as a scenario sees it: start programs, listen, act, wait.

One arena serves one scenario. Everything that happens in it is recorded on its time line. When it is
closed, every process that was started in it, directly or indirectly, has ended.
"""

from __future__ import annotations

import contextlib
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast

from course.arena.arena_node import ArenaNode, NoRos
from course.arena.command_lines import ParameterValue, command_for, ros_args
from course.arena.cpp_programs import CppPrograms
from course.arena.home_programs import HomePrograms, Surroundings
from course.arena.lateness import Lateness, measured_lateness
from course.arena.mystery_nodes import our_environment, start_in_arena
from course.arena.process import Process, started_by, still_there
from course.errors import OurFault
from course.evidence.acts import MYSTERY
from course.evidence.packages import BuiltPackages
from course.evidence.recording import ROSOUT
from course.evidence.sources import MAX_FILE
from course.evidence.timeline import Timeline
from course.isolation.none import end_descendants
from course.isolation.sandbox import start_here
from course.model.events import (
    Drawn,
    ExecutableMissing,
    FileKept,
    Marked,
    MessageSeen,
    OutputLine,
    ProcessLeft,
)
from course.model.feedback import Spoilt
from course.spelling import did_you_mean

if TYPE_CHECKING:
    from course.evidence.recorder import Recorder, Stimulus

# The course asks for 3 s; the rest is slack for a busy machine.
INTERRUPT_GRACE = 4.0
_ANSWER_TIME = 1.0


class Arena(HomePrograms):
    """Where the learner's nodes run under observation.

    ros: the arena's own ROS node (`arena.ros.subscribe`). cpp: the learner's C++ (`arena.cpp.compile`).
    packages: what was built. lateness: measures delays caused by this machine; None if no check needs that.
    """

    def __init__(
        self,
        recorder: Recorder,
        packages: BuiltPackages,
        given: Surroundings,
        lateness: Lateness | None = None,
    ) -> None:
        super().__init__(recorder.timeline, given)
        self.ros = ArenaNode(recorder)
        self.cpp = CppPrograms(self)
        self._lateness = lateness
        self._packages = packages
        self._started_ours: list[Process] = []

    def run(
        self,
        package: str,
        executable: str,
        *args: str,
        name: str | None = None,
        env: Mapping[str, str] | None = None,
        params: Mapping[str, ParameterValue] | None = None,
        remaps: Mapping[str, str] | None = None,
        node_name: str | None = None,
    ) -> Process | None:
        """Start what `ros2 run package executable args...` would start.

        If no such executable is installed, returns None and records what is installed instead. name: what
        the recording calls it; the executable's name by default. params, remaps, node_name: passed to its
        nodes after `--ros-args`; a string stays a string. Raises OurFault for a package that the exercise
        does not have.
        """
        name = name or executable
        built = self._packages.get(package)
        if built is None:  # not because its build failed: then no scenario runs
            what = f"the scenario runs `{package}`, which is not among the exercise's packages"
            raise OurFault(what + did_you_mean(package, (one.name for one in self._packages.built)))
        if executable not in built.executables:
            missing = ExecutableMissing(self.timeline.now(), name, package, executable, built.executables)
            self.timeline.add(missing)
            return None
        command = command_for(Path(built.prefix), package, executable, self._python)
        return self.start(*command, *args, *ros_args(params, remaps, node_name), name=name, env=env)

    def launch(self, package: str, file: str, **arguments: str) -> Process:
        """Start `ros2 launch package file argument:=value...`, which itself reports anything missing.

        The recording calls it by the file's name.
        """
        given = (f"{key}:={value}" for key, value in arguments.items())
        return self.start("ros2", "launch", package, file, *given, name=file)

    def start(self, *command: str, name: str, env: Mapping[str, str] | None = None) -> Process:
        """Start any command in its own terminal, with the learner's packages on top of ROS."""
        return self._launch(name, command, {**self._programs(), **(env or {})})

    def start_ours(self, *command: str, name: str, env: Mapping[str, str]) -> Process:
        """Start a program of the course, which the learner's programs can neither see nor reach."""
        process = self._launch(name, command, {**self._programs(), **env}, self._ours, start=start_here)
        self._started_ours.append(process)
        return process

    def play_along(self, file: Path, *args: str, name: str) -> Process:
        """Start a Python file of the course that creates nodes for the learner's nodes to talk to."""
        # Programs that run as another user cannot write to a log folder that we made.
        env = {**our_environment(), "ROS_LOG_DIR": str(self._ours / "log")}
        return self.start_ours(sys.executable, str(file), *args, name=name, env=env)

    def until(
        self,
        condition: Callable[[], Any],
        *,
        timeout: float,
        while_running: Process | None = None,
    ) -> bool:
        """Wait until `condition()` is true and return True; False after `timeout` s or when the program ends.

        condition: must be quick, and depend only on what the arena has seen so far.
        """

        def settled() -> bool:
            return bool(condition()) or bool(while_running and not while_running.running)

        self.timeline.wait_until(settled, timeout)
        return bool(condition())

    def say(
        self,
        speaker: Stimulus,
        messages: Iterable[Mapping[str, Any]],
        answered: Callable[[Mapping[str, Any]], Any],
        *,
        while_running: Process | None = None,
    ) -> None:
        """Publish messages one by one, each after the previous one was answered; see `recording.reactions`.

        messages: the fields of each. answered: called with these fields; returns true once the answer has
        been seen; quick, as in `until`. After 1 s without an answer, the next message is sent.
        """
        for fields in messages:
            if while_running and not while_running.running:
                return
            speaker.publish(**fields)
            self.until(partial(answered, fields), timeout=_ANSWER_TIME, while_running=while_running)

    def interrupt(self, process: Process | None, grace: float = INTERRUPT_GRACE) -> None:
        """Press Ctrl+C in this program's terminal, and kill it if it is still running after `grace` seconds.

        Ctrl+C proves nothing before the program has a handler, so wait for its node first. Any process that
        it started and leaves running is recorded.
        """
        if process is None:
            return
        below = started_by(process.pid) if process.running else ()
        process.interrupt()
        if not process.wait(grace):
            self.timeline.add(Marked(self.timeline.now(), f"ignored Ctrl+C: {process.name}"))
            process.close()
        for pid, command in still_there(below):
            self.timeline.add(ProcessLeft(self.timeline.now(), process.name, pid, command))

    def logged(self, text: str) -> int:
        """Return how many messages logged so far contain this text."""
        needle = text.encode()
        return self.timeline.count(
            MessageSeen, text, lambda event: event.topic == ROSOUT and needle in _logged(event.data)
        )

    def printed(self, text: str) -> int:
        """Return how many lines on the programs' terminals so far contain this text."""
        return self.timeline.count(OutputLine, text, lambda event: text in event.text)

    def lines(self, process: Process) -> tuple[str, ...]:
        """Return what this program has printed so far, line by line."""
        return tuple(line.text for line in self.timeline.of(OutputLine) if line.process == process.name)

    def keep(self, package: str, file: str) -> None:
        """Keep an installed text file (relative to the package's prefix) in the recording."""
        built = self._packages.get(package)
        path = Path(built.prefix, file) if built else None
        text = _beginning(path) if path and path.is_file() else None
        self.timeline.add(FileKept(self.timeline.now(), file, text))

    def mark(self, name: str, detail: str = "") -> None:
        """Name this moment in the recording."""
        self.timeline.add(Marked(self.timeline.now(), name, detail))

    def ticks(self, period: float, count: int) -> Iterator[int]:
        """Yield 0, 1, 2, ... (`count` numbers), one every `period` seconds by our clock, to time messages."""
        began = time.monotonic()
        for number in range(count):
            due = began + number * period
            time.sleep(max(0.0, due - time.monotonic()))  # noqa: TID251 - keeping time is its job
            yield number

    def lateness(self) -> contextlib.AbstractContextManager[None]:
        """Inside this context, measure how late programs get to run: see `recording.is_overloaded`."""
        return self._lateness.noted() if self._lateness else contextlib.nullcontext()

    @property
    def worst_lag(self) -> float:
        """The longest time so far (s) that a program had to wait because of this machine alone."""
        return self._lateness.update() if self._lateness else 0.0

    @property
    def seed(self) -> int | None:
        """The seed of the exercise's mystery; None without a mystery."""
        return next((event.seed for event in self.timeline.of(Drawn)), None)

    def play(self, file: Path) -> Process:
        """Start the nodes of the exercise's mystery (`mystery.file`); returns when all of them are up."""

        def start(command: tuple[str, ...], env: Mapping[str, str]) -> Process:
            return self.start_ours(*command, name=MYSTERY, env=env)

        return start_in_arena(file, self.seed, self.timeline, start)

    def require_ours(self) -> None:
        """Raise Spoilt if anyone else has killed a program of the course; called at the end."""
        for process in self._started_ours:
            if process.killed_by_others:
                raise Spoilt(f"One of the course's own programs ({process.name}) was killed from outside.")

    def close(self) -> None:
        """End everything that was started here."""
        for process in self._processes:
            process.close()
        end_descendants()
        self._domains.close()


def _logged(log: bytes) -> bytes:
    """The field `msg` of a serialized rcl_interfaces/msg/Log, which follows stamp, level and name."""
    order: Literal["little", "big"] = "little" if log[1:2] == b"\1" else "big"
    name = 16
    message = name + 4 + (int.from_bytes(log[name : name + 4], order) + 3 & ~3)
    return log[message + 4 : message + 4 + int.from_bytes(log[message : message + 4], order)]


def _beginning(file: Path) -> str:
    with file.open("rb") as stream:
        return stream.read(MAX_FILE).decode("utf-8", errors="replace")


def _recorder(timeline: Timeline) -> contextlib.AbstractContextManager[Recorder]:
    from course.evidence.recorder import Recorder  # the only thing here that needs ROS

    return Recorder(timeline)


def _no_ros(timeline: Timeline) -> contextlib.AbstractContextManager[Recorder]:
    return contextlib.nullcontext(cast("Recorder", NoRos(timeline)))


@contextlib.contextmanager
def open_arena(
    timeline: Timeline,
    packages: BuiltPackages,
    given: Surroundings,
    *,
    ros: bool = True,
    groups: Sequence[Path] = (),
) -> Iterator[Arena]:
    """Open an arena whose recorder is listening before any program starts; without a recorder if not `ros`.

    Without a `place`, programs run in `folder` without a sandbox. groups: the programs' control groups.
    """
    with (
        measured_lateness(timeline, groups) as lateness,
        _recorder(timeline) if ros else _no_ros(timeline) as recorder,
    ):
        arena = Arena(recorder, packages, given, lateness)
        try:
            yield arena
        finally:
            arena.close()
