"""Run `ros2` of the underlay in a child, as a learner with ROS from pip does."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import threading
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from course.rosenv import find_ros, node_environment

REPOSITORY = Path(__file__).parents[3]
PACKAGES = REPOSITORY / "underlay" / "src"
SOLUTIONS = REPOSITORY / "solutions"
TIMEOUT = 30.0


@dataclass(frozen=True)
class Answer:
    """What a command left behind."""

    code: int
    stdout: str
    stderr: str


@dataclass(frozen=True)
class Ros2:
    """The command, where the packages of a workspace are installed."""

    python: Path
    environment: Mapping[str, str]
    cwd: Path
    workspace: Path

    def line(self, *arguments: str) -> list[str]:
        """Return the command line of `ros2 ...`."""
        return [str(self.python), "-m", "ros2cli", *arguments]

    def __call__(self, *arguments: str, text: str = "", **variables: str) -> Answer:
        done = subprocess.run(
            self.line(*arguments),
            cwd=self.cwd,
            env={**self.environment, **variables},
            input=text,
            capture_output=True,
            text=True,
            timeout=TIMEOUT,
            check=False,
        )
        return Answer(done.returncode, done.stdout, done.stderr)

    @contextlib.contextmanager
    def started(self, *arguments: str) -> Iterator[subprocess.Popen[str]]:
        """Start `ros2 ...` as the head of a process group of its own, which ends with the block."""
        with subprocess.Popen(
            self.line(*arguments),
            cwd=self.cwd,
            env=dict(self.environment),
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            start_new_session=True,
        ) as process:
            limit = threading.Timer(TIMEOUT, _kill_group, [process.pid])  # a reader would wait for ever
            limit.start()
            try:
                yield process
            finally:
                limit.cancel()
                _kill_group(process.pid)


def _kill_group(pid: int) -> None:
    with contextlib.suppress(ProcessLookupError):
        os.killpg(pid, signal.SIGKILL)


def ros2_command(cwd: Path, workspace: Path, python_folders: Sequence[Path] = ()) -> Ros2:
    """Return the command. Python finds the underlay's packages and those of `python_folders`."""
    ros = find_ros()
    environment = node_environment(ros)
    prefixes = sorted((workspace / "install").iterdir())
    environment["AMENT_PREFIX_PATH"] = _joined(*prefixes, environment.get("AMENT_PREFIX_PATH", ""))
    environment["PYTHONPATH"] = _joined(*python_folders, environment.get("PYTHONPATH", ""))
    environment |= {"COLUMNS": "80", "USER": "root", "LOGNAME": "root"}
    return Ros2(ros.python, environment, cwd, workspace)


def _joined(*parts: Path | str) -> str:
    return os.pathsep.join(str(part) for part in parts if str(part))
