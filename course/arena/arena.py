"""The arena as a scenario sees it: start programs, listen, act, wait.

One arena serves one scenario. Everything that happens in it goes to its time line; when it
is closed, every process that was started in it, or by one of them, has ended.
"""

from __future__ import annotations

import contextlib
import sys
import time
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, cast

from course.arena.executables import command_for
from course.arena.lateness import noted_lateness
from course.arena.leftovers import end_descendants
from course.arena.no_ros import NoRos
from course.arena.own_programs import OwnPrograms
from course.arena.play_here import our_environment, play_here
from course.arena.process import Process
from course.arena.ros_args import ParameterValue, ros_args
from course.arena.starting import Starter, start_here
from course.arena.survivors import started_by, still_there
from course.evidence.events import (
    Drawn,
    ExecutableMissing,
    FileKept,
    Marked,
    MessageSeen,
    OutputLine,
    ProcessLeft,
)
from course.evidence.graph import Graph
from course.evidence.packages import BuiltPackages
from course.evidence.recording import ROSOUT
from course.evidence.sources import MAX_FILE
from course.evidence.timeline import Timeline

if TYPE_CHECKING:
    from course.evidence.recorder import Listener, Recorder, Stimulus
    from course.evidence.ros_parameters import Parameters
    from course.evidence.ros_services import Answer, Client, Server

# The course asks for 3 s; the rest is for a machine that has other things to do.
INTERRUPT_GRACE = 4.0
TYPE_PROBE = "type probe"
_TYPE_PROBE = Path(__file__).with_name("type_probe.py")


class Arena(OwnPrograms):
    """Where the learner's nodes run while they are watched.

    packages: what was built. environment: for the learner's programs. python: the
    interpreter that runs Python nodes. folder: a scratch folder; `home` in it is their HOME.
    plain: the environment for programs that need no ROS. learners_home: the course home itself.
    ours, confined: see `HomePrograms`.
    """

    def __init__(
        self,
        recorder: Recorder,
        packages: BuiltPackages,
        environment: Mapping[str, str],
        python: str,
        folder: Path,
        plain: Mapping[str, str] = MappingProxyType({}),
        learners_home: Path | None = None,
        ours: Path | None = None,
        confined: Starter = start_here,
    ) -> None:
        super().__init__(recorder.timeline, environment, plain, python, folder, learners_home, ours, confined)
        self._recorder = recorder
        self._packages = packages

    @property
    def graph(self) -> Graph:
        """The ROS graph now, without the arena's own nodes."""
        return self._recorder.graph

    @property
    def definitions(self) -> dict[str, str]:
        """Text definitions of all message types in the recording."""
        return self._recorder.definitions

    def subscribe(self, topic: str, type_name: str, **qos: str) -> Listener:
        """Record every message on `topic` (full name) of type `pkg/msg/Type` from now on.

        qos: `reliability` and `durability`; by default what suits any publisher.
        """
        return self._recorder.subscribe(topic, type_name, **qos)

    def publisher(self, topic: str, type_name: str, **qos: str) -> Stimulus:
        """A publisher of the arena's own, reliable and volatile unless said otherwise."""
        return self._recorder.publisher(topic, type_name, **qos)

    def client(self, service: str, type_name: str, *, name: str | None = None) -> Client:
        """A client of the arena's own for a service (full name) of type `pkg/srv/Type`."""
        return self._recorder.client(service, type_name, name)

    def serve(self, service: str, type_name: str, answer: Answer) -> Server:
        """A server of the arena's own; `answer` gets a request and returns the response's fields, or None."""
        return self._recorder.serve(service, type_name, answer)

    def parameters(self, node: str) -> Parameters:
        """The parameters of the node of that full name, asked from outside; it need not be there yet."""
        return self._recorder.parameters(node)

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

        Returns None, and records what there is instead, when no such executable is installed.
        name: what the recording calls it; the executable's name by default.
        params, remaps, node_name: given to its nodes after `--ros-args`; a string stays a string.
        """
        name = name or executable
        built = self._packages.get(package)
        if built is None or executable not in built.executables:
            available = built.executables if built else ()
            self.timeline.add(ExecutableMissing(self.timeline.now(), name, package, executable, available))
            return None
        command = command_for(Path(built.prefix), package, executable, self._python)
        return self.start(*command, *args, *ros_args(params, remaps, node_name), name=name, env=env)

    def launch(self, package: str, file: str, *, name: str | None = None, **arguments: str) -> Process:
        """Start `ros2 launch package file argument:=value...`; what it lacks, it says itself.

        name: what the recording calls it; the file's name by default.
        """
        given = (f"{key}:={value}" for key, value in arguments.items())
        return self.start("ros2", "launch", package, file, *given, name=name or file)

    def start(self, *command: str, name: str, env: Mapping[str, str] | None = None) -> Process:
        """Start any command on a terminal of its own, with the learner's packages on top of ROS."""
        return self._launch(name, command, {**self._programs(), **(env or {})})

    def start_ours(self, *command: str, name: str, env: Mapping[str, str]) -> Process:
        """Start a program of the course's own, which the learner's programs neither see nor reach."""
        return self._launch(name, command, {**self._programs(), **env}, self._ours, start=start_here)

    def play_along(self, file: Path, *args: str, name: str) -> Process:
        """Start a Python file of the course's own that makes nodes for the learner's to talk to."""
        # Where we have made a log, programs that run as somebody else cannot write.
        env = {**our_environment(), "ROS_LOG_DIR": str(self._ours / "log")}
        return self.start_ours(sys.executable, str(file), *args, name=name, env=env)

    def until(
        self,
        condition: Callable[[], Any],
        *,
        timeout: float,
        while_running: Process | None = None,
        name: str = "",
    ) -> bool:
        """Wait until `condition()` holds: True; False after `timeout` s or when the program ended.

        condition: quick, and true or false by what the arena has seen up to now.
        name: marks the giving up in the recording, for checks to know.
        """

        def settled() -> bool:
            return bool(condition()) or bool(while_running and not while_running.running)

        self.timeline.wait_until(settled, timeout)
        if condition():
            return True
        if name:
            self.timeline.add(Marked(self.timeline.now(), f"gave up: {name}"))
        return False

    def interrupt(self, process: Process | None, grace: float = INTERRUPT_GRACE) -> None:
        """Press Ctrl+C at this program and give it `grace` seconds to end; then it is killed.

        A program that has no handler yet has not been asked: wait for its node first.
        What it had started and leaves running is recorded.
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
        """How many /rosout messages up to now hold this text."""
        needle = text.encode()
        return sum(1 for e in self.timeline.of(MessageSeen) if e.topic == ROSOUT and needle in e.data)

    def printed(self, text: str) -> int:
        """How many lines on the programs' terminals up to now hold this text."""
        return sum(1 for event in self.timeline.of(OutputLine) if text in event.text)

    def keep(self, package: str, file: str) -> None:
        """Keep an installed text file (relative to the package's prefix) in the recording."""
        built = self._packages.get(package)
        path = Path(built.prefix, file) if built else None
        text = _beginning(path) if path and path.is_file() else None
        self.timeline.add(FileKept(self.timeline.now(), file, text))

    def probe_types(self, *types: str) -> Process:
        """Start a program of ours that offers endpoints of these types as the learner built them.

        For the n-th type (from 0) a publisher or service `/probe/tN`; the graph then shows the
        hash of the type's definition. It prints `missing <type>` for what cannot be imported.
        """
        return self.start(self._python, str(_TYPE_PROBE), *types, name=TYPE_PROBE)

    def mark(self, name: str, detail: str = "") -> None:
        """Name this moment in the recording."""
        self.timeline.add(Marked(self.timeline.now(), name, detail))

    def ticks(self, period: float, count: int) -> Iterator[int]:
        """0, 1, 2, ... so many, one every `period` seconds by our clock: for a stimulus that keeps time."""
        began = time.monotonic()
        for number in range(count):
            due = began + number * period
            time.sleep(max(0.0, due - time.monotonic()))  # noqa: TID251 - it is time itself that is kept
            yield number

    def lateness(self) -> contextlib.AbstractContextManager[None]:
        """Within it is noted how late this machine lets programs go on: see `expect.streams`."""
        return noted_lateness(self.timeline)

    @property
    def seed(self) -> int | None:
        """What the exercise's mystery is drawn from; None without one."""
        return next((event.seed for event in self.timeline.of(Drawn)), None)

    def play(self, file: Path) -> Process:
        """Start the nodes of the exercise's mystery (`mystery.file`); returns when all are up."""
        return play_here(self, file)

    def close(self) -> None:
        """End everything that was started here."""
        for process in self._processes:
            process.close()
        end_descendants()
        self._domains.close()


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
    environment: Mapping[str, str],
    python: str,
    folder: Path,
    *,
    plain: Mapping[str, str] = MappingProxyType({}),
    ros: bool = True,
    learners_home: Path | None = None,
    ours: Path | None = None,
    confined: Starter = start_here,
) -> Iterator[Arena]:
    """An arena whose recorder listens before anything is started in it; without one if not `ros`."""
    folder.mkdir(parents=True, exist_ok=True)
    with _recorder(timeline) if ros else _no_ros(timeline) as recorder:
        arena = Arena(recorder, packages, environment, python, folder, plain, learners_home, ours, confined)
        try:
            yield arena
        finally:
            arena.close()
