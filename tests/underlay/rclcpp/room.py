"""Programs in C++ on one side, rclpy and `ros2` on the other."""

from __future__ import annotations

import contextlib
import shutil
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from course.build.builder import build
from course.build.store import Store
from course.build.underlay_build import provide
from course.build.workspace import Workspace
from course.isolation.levels import isolated
from course.rosenv import find_ros, node_environment, prepare

SOURCES = Path(__file__).parents[3] / "underlay" / "src" / "rclcpp"
PROBES = Path(__file__).with_name("probes")
_PEER = Path(__file__).with_name("peer.py")
TIME_LIMIT = 1800.0  # of a build: a machine may be busy
_TIMEOUT = 300.0


def built(root: Path, sources: Path, package: str) -> list[Path]:
    """Where the programs in `sources` and what they use are installed; `root` is an empty folder.

    What was built of the same sources before is not built again.
    """
    shutil.copytree(sources, root / "src" / sources.name)
    ros = find_ros()
    prepare(ros)
    workspace = Workspace.scan(root, trusted=True)
    provide(workspace, [package], ros)
    outcome = build(workspace, [package], ros, Store(), time_limit=TIME_LIMIT)
    assert outcome.failure is None, outcome.failure
    return [one.prefix for one in reversed(outcome.packages)]


@contextlib.contextmanager
def open_room(prefixes: list[Path], folder: Path, package: str) -> Iterator[Room]:
    """Starts programs of this package, which `built` built, that hear each other and nobody else."""
    with isolated(namespaces=False) as place:
        no_daemon = {"ROS2COURSE_ARENA": "1"}  # it would outlive the test
        environment = {**node_environment(find_ros(), prefixes), **place.environment, **no_daemon}
        yield Room(environment, folder, prefixes[0] / "lib" / package)


@dataclass(frozen=True)
class Ended:
    """How a program ended, and all that it said."""

    code: int
    text: str


@dataclass(frozen=True)
class Started:
    """A program that runs."""

    process: subprocess.Popen[str]

    def until(self, text: str) -> str:
        """All that it says up to the line that holds `text`; fails when it ends without having said it."""
        assert self.process.stdout is not None
        said = ""
        for line in self.process.stdout:
            said += line
            if text in line:
                return said
        raise AssertionError(f"it never said {text!r}, but:\n{said}")

    def end(self, number: signal.Signals = signal.SIGINT) -> Ended:
        """Send a signal, and wait for the end."""
        self.process.send_signal(number)
        text, _ = self.process.communicate(timeout=_TIMEOUT)
        return Ended(self.process.returncode, text)

    def wait(self) -> Ended:
        """Wait until it ends by itself."""
        text, _ = self.process.communicate(timeout=_TIMEOUT)
        return Ended(self.process.returncode, text)


@dataclass(frozen=True)
class Room:
    """Where programs are started. `folder` is for what they write."""

    environment: Mapping[str, str]
    folder: Path
    programs: Path

    @contextlib.contextmanager
    def started(self, *command: str | Path, **variables: str) -> Iterator[Started]:
        """Start a command that ends with the block, and in any case after five minutes."""
        with subprocess.Popen(
            command,
            cwd=self.folder,
            env={**self.environment, **variables},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        ) as process:
            limit = threading.Timer(_TIMEOUT, process.kill)  # a reader would wait for ever
            limit.start()
            try:
                yield Started(process)
            finally:
                limit.cancel()
                process.kill()

    def program(self, name: str, *words: str, **variables: str) -> contextlib.AbstractContextManager[Started]:
        """Start one of the programs in C++."""
        return self.started(self.programs / name, *words, **variables)

    def peer(self, *words: str) -> contextlib.AbstractContextManager[Started]:
        """Start the other side, in Python."""
        return self.started(sys.executable, _PEER, *words)

    def run(self, name: str, *words: str, **variables: str) -> Ended:
        """Run one of the programs in C++ to its end."""
        with self.program(name, *words, **variables) as started:
            return started.wait()

    def ros2(self, *words: str) -> Ended:
        """Run the command `ros2` to its end."""
        with self.started(find_ros().python, "-m", "ros2cli", *words) as started:
            return started.wait()
