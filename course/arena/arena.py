"""The arena as a scenario sees it: start programs, listen, act, wait.

One arena serves one scenario. Everything that happens in it goes to its time line; when it
is closed, every process that was started in it, or by one of them, has ended.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from course.arena.executables import command_for
from course.arena.leftovers import end_descendants
from course.arena.process import Process
from course.errors import OurFault
from course.evidence.events import ExecutableMissing, FileKept, Marked, MessageSeen, OutputLine
from course.evidence.graph import Graph
from course.evidence.packages import BuiltPackages
from course.evidence.recording import ROSOUT
from course.evidence.sources import MAX_FILE
from course.evidence.timeline import Timeline

if TYPE_CHECKING:
    from course.evidence.recorder import Listener, Recorder, Stimulus

# The course asks for 3 s; the rest is for a machine that has other things to do.
INTERRUPT_GRACE = 4.0
TYPE_PROBE = "type probe"
_TYPE_PROBE = Path(__file__).with_name("type_probe.py")


class Arena:
    """Where the learner's nodes run while they are watched.

    packages: what was built. environment: for the learner's programs. python: the
    interpreter that runs Python nodes. folder: a scratch folder, their HOME.
    """

    def __init__(
        self,
        recorder: Recorder,
        packages: BuiltPackages,
        environment: Mapping[str, str],
        python: str,
        folder: Path,
    ) -> None:
        self.timeline: Timeline = recorder.timeline
        self._recorder = recorder
        self._packages = packages
        self._environment = environment
        self._python = python
        self._folder = folder
        self._processes: list[Process] = []

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

    def run(
        self,
        package: str,
        executable: str,
        *args: str,
        name: str | None = None,
        env: Mapping[str, str] | None = None,
    ) -> Process | None:
        """Start what `ros2 run package executable args...` would start.

        Returns None, and records what there is instead, when no such executable is installed.
        name: what the recording calls it; the executable's name by default.
        """
        name = name or executable
        built = self._packages.get(package)
        if built is None or executable not in built.executables:
            available = built.executables if built else ()
            self.timeline.add(ExecutableMissing(self.timeline.now(), name, package, executable, available))
            return None
        command = command_for(Path(built.prefix), package, executable, self._python)
        return self.start(*command, *args, name=name, env=env)

    def start(self, *command: str, name: str, env: Mapping[str, str] | None = None) -> Process:
        """Start any command on a terminal of its own, with the learner's packages on top of ROS."""
        if any(process.name == name for process in self._processes):
            raise OurFault(f"the scenario starts two programs under the name {name}")
        environment = {**self._environment, **self._own_environment(), **(env or {})}
        process = Process(name, command, env=environment, cwd=self._folder, timeline=self.timeline)
        self._processes.append(process)
        return process

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
        """
        if process is None:
            return
        process.interrupt()
        if not process.wait(grace):
            self.timeline.add(Marked(self.timeline.now(), f"ignored Ctrl+C: {process.name}"))
            process.close()

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

    def close(self) -> None:
        """End everything that was started here."""
        for process in self._processes:
            process.close()
        end_descendants()

    def _own_environment(self) -> dict[str, str]:
        return {
            "HOME": str(self._folder),
            "TMPDIR": str(self._folder),
            "ROS_LOG_DIR": str(self._folder / "log"),
            "TERM": "xterm",
            "RCUTILS_COLORIZED_OUTPUT": "0",
            # A field of the wrong type is an exception that says so, and not an abort in C.
            "ROS_PYTHON_CHECK_FIELDS": "1",
            # Bytecode would be written into the build cache.
            "PYTHONDONTWRITEBYTECODE": "1",
        }


def _beginning(file: Path) -> str:
    with file.open("rb") as stream:
        return stream.read(MAX_FILE).decode("utf-8", errors="replace")


@contextlib.contextmanager
def open_arena(
    timeline: Timeline, packages: BuiltPackages, environment: Mapping[str, str], python: str, folder: Path
) -> Iterator[Arena]:
    """An arena whose recorder listens before anything is started in it."""
    from course.evidence.recorder import Recorder  # the only thing here that needs ROS

    folder.mkdir(parents=True, exist_ok=True)
    with Recorder(timeline) as recorder:
        arena = Arena(recorder, packages, environment, python, folder)
        try:
            yield arena
        finally:
            arena.close()
