"""Runs `ros2 launch` of the underlay in a child, in a workspace of small programs that need no ROS."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

TIMEOUT = 60.0
HEADER = """
import os
import sys
from launch import *
from launch.actions import *
from launch.conditions import *
from launch.event_handlers import *
from launch.events import matches_action
from launch.events.process import ShutdownProcess, SignalProcess
from launch.launch_description_sources import *
from launch.substitutions import *
from launch_ros.actions import *
from launch_ros.substitutions import FindPackagePrefix, FindPackageShare
from launch_ros.parameter_descriptions import ParameterFile, ParameterValue
import launch_ros.parameter_descriptions
"""


@dataclass(frozen=True)
class Answer:
    """What a launch left behind. `said` is its output without the two lines that every launch begins with."""

    code: int
    stdout: str
    stderr: str

    @property
    def said(self) -> list[str]:
        lines = self.stdout.splitlines()
        assert lines[0].startswith("[INFO] [launch]: All log files can be found below "), self
        assert lines[1] == "[INFO] [launch]: Default logging verbosity is set to INFO", self
        return lines[2:]

    @property
    def logged(self) -> list[str]:
        """What LogInfo said."""
        head = "[INFO] [launch.user]: "
        return [line.removeprefix(head) for line in self.said if line.startswith(head)]

    def of(self, process: str) -> list[str]:
        """What a process wrote."""
        head = f"[{process}] "
        return [line.removeprefix(head) for line in self.said if line.startswith(head)]


class Running:
    """A launch that goes on; its output is read line by line."""

    def __init__(self, process: subprocess.Popen[str]) -> None:
        self.process = process
        self.lines: list[str] = []

    def wait_for(self, text: str, times: int = 1) -> str:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self.lines.append(line.rstrip("\n"))
            times -= text in line
            if times == 0:
                return self.lines[-1]
        raise AssertionError(f"{text!r} never came: {self.lines}")

    def wait_for_all(self, *texts: str) -> None:
        """In whatever order they come."""
        missing = {*texts}
        while missing:
            line = self.wait_for("")
            missing = {text for text in missing if text not in line}

    def pid_of(self, process: str) -> int:
        line = self.wait_for(f"[{process}]: process started with pid [")
        return int(line.rpartition("[")[2].rstrip("]"))

    def signal(self, number: signal.Signals) -> None:
        self.process.send_signal(number)

    def finish(self) -> Answer:
        stdout, stderr = self.process.communicate(timeout=TIMEOUT)
        return Answer(self.process.returncode, "\n".join([*self.lines, *stdout.splitlines()]), stderr)


@dataclass(frozen=True)
class Launcher:
    """`cwd` is where launch files are written; `workspace` has the install folder."""

    python: Path
    environment: Mapping[str, str]
    cwd: Path
    workspace: Path

    @property
    def home(self) -> Path:
        return Path(self.environment["HOME"])

    def line(self, *words: str) -> list[str]:
        return [str(self.python), "-m", "ros2cli", "launch", *words]

    def __call__(self, *words: str | Path, **variables: str) -> Answer:
        with self.started(*words, **variables) as running:
            return running.finish()

    def file(self, source: str, name: str = "test_launch.py") -> Path:
        path = self.cwd / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(source, encoding="utf-8")
        return path

    def description(self, entities: str, before: str = "", name: str = "test_launch.py") -> Path:
        """A launch file of these entities; `before` are statements that come before."""
        body = f"def generate_launch_description():\n    return LaunchDescription([{entities}])\n"
        return self.file(f"{HEADER}\n{before}\n{body}", name)

    def run(self, entities: str, *words: str, before: str = "", **variables: str) -> Answer:
        return self(self.description(entities, before), *words, **variables)

    @contextlib.contextmanager
    def started(self, *words: str | Path, **variables: str) -> Iterator[Running]:
        with subprocess.Popen(
            self.line(*map(str, words)),
            cwd=self.cwd,
            env={**self.environment, **variables},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
        ) as process:
            try:
                yield Running(process)
            finally:
                with contextlib.suppress(ProcessLookupError):
                    os.killpg(process.pid, signal.SIGKILL)


def alive(pid: int) -> bool:
    """Whether a process runs; one that is dead and not yet fetched does not."""
    try:
        state = Path(f"/proc/{pid}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()[0]
    except (FileNotFoundError, ProcessLookupError):
        return False
    return state != "Z"


def gone(pid: int) -> bool:
    return comes_true(lambda: not alive(pid))


def there(path: Path) -> None:
    """Wait for a file, with which a process says that it is ready."""
    assert comes_true(path.exists), path


def comes_true(what: Callable[[], bool], within: float = 10.0) -> bool:
    until = time.monotonic() + within
    while not what() and time.monotonic() < until:
        time.sleep(0.01)
    return what()
