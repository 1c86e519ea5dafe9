"""A machine made of small files: a clone that holds only the launcher, and a PATH with made-up Pythons.

The PATH holds nothing but the tools linked here, so these tests also say what the launcher needs.
"""

from __future__ import annotations

import contextlib
import os
import select
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import pytest

REPO = Path(__file__).parents[2]
TOOLS = ("cat", "cksum", "cp", "grep", "mkdir", "mv", "readlink", "rm", "sed", "sh", "tail", "touch")
GUARD = 30.0  # seconds after which a test is lost


@dataclass
class Machine:
    """One clone on one machine. Its Pythons are named in `python()`, its programs' calls are in `calls()`."""

    clone: Path
    bin: Path
    fake: Path
    opt_ros: Path
    running: list[subprocess.Popen[str]] = field(default_factory=list)

    def python(self, name: str, *, version: str = "3.11", kind: str = "cpython", venv: bool = True,
               libc: str = "glibc-2.36") -> None:  # fmt: skip
        shutil.copy(Path(__file__).parent / "fake_python.sh", self.bin / name)
        answer = [*version.split("."), kind, "yes" if venv else "no", libc]
        (self.fake / "answers" / name).write_text(" ".join(answer))

    def uname(self, system: str = "Linux", machine: str = "x86_64") -> None:
        self.script("uname", f'case $1 in -s) echo {system} ;; -m) echo {machine} ;; esac')

    def script(self, name: str, body: str) -> None:
        file = self.bin / name
        file.write_text(f"#!/bin/sh\n{body}\n")
        file.chmod(0o755)

    def ros(self, prefix: Path, python: str = "3.11") -> Path:
        """Puts what a ROS 2 looks like to the launcher into a folder."""
        marker = prefix / "share/ament_index/resource_index/packages/rclpy"
        marker.parent.mkdir(parents=True)
        marker.touch()
        (prefix / "setup.bash").touch()
        (prefix / f"lib/python{python}/site-packages/rclpy").mkdir(parents=True)
        return prefix

    def environment(self, extra: dict[str, str]) -> dict[str, str]:
        return {"PATH": str(self.bin), "FAKE": str(self.fake), "REAL_PYTHON": sys.executable, **extra}

    def start(self, *args: str, launcher: Path | None = None, cwd: Path | None = None,
              **environment: str) -> subprocess.Popen[str]:  # fmt: skip
        process = subprocess.Popen(
            [launcher or self.clone / "ros2course", *args],
            cwd=cwd or self.clone, env=self.environment(environment), text=True, start_new_session=True,
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        )  # fmt: skip
        self.running.append(process)
        return process

    def run(self, *args: str, launcher: Path | None = None, cwd: Path | None = None,
            **environment: str) -> subprocess.CompletedProcess[str]:  # fmt: skip
        process = self.start(*args, launcher=launcher, cwd=cwd, **environment)
        return finish(process)

    def calls(self, kind: str = "") -> list[str]:
        """What the Pythons were asked to do: lines that begin with venv, pip or run."""
        file = self.fake / "calls"
        lines = file.read_text().splitlines() if file.exists() else []
        return [line for line in lines if line.startswith(kind)]

    def pip_waits(self) -> None:
        """From now on pip says that it started, then waits until `let_pip_go`."""
        for name in ("pip_started", "pip_waits"):
            os.mkfifo(self.fake / name)

    def until_pip_started(self) -> None:
        # Opened for both directions, so that neither side waits for the other to open it.
        pipe = os.open(self.fake / "pip_started", os.O_RDWR)
        try:
            assert select.select([pipe], [], [], GUARD)[0], "pip was not started"
            os.read(pipe, 100)
        finally:
            os.close(pipe)

    def let_pip_go(self) -> None:
        waits = self.fake / "pip_waits"
        with waits.open("w") as pipe:  # opens when pip reads
            waits.rename(waits.with_suffix(".gone"))  # the next pip does not wait
            pipe.write("go\n")


def finish(process: subprocess.Popen[str]) -> subprocess.CompletedProcess[str]:
    stdout, stderr = process.communicate(timeout=GUARD)
    return subprocess.CompletedProcess(process.args, process.returncode, stdout, stderr)


@pytest.fixture
def machine(tmp_path: Path) -> Iterator[Machine]:
    """Linux on x86-64 with a Python 3.11, no ROS, and a clone in a folder with a space in its name."""
    machine = Machine(tmp_path / "my clone", tmp_path / "bin", tmp_path / "fake", tmp_path / "opt/ros/jazzy")
    for folder in (machine.clone, machine.bin, machine.fake / "answers"):
        folder.mkdir(parents=True)
    for tool in TOOLS:
        (machine.bin / tool).symlink_to(shutil.which(tool) or pytest.fail(f"no {tool} here"))
    text = (REPO / "ros2course").read_text()
    elsewhere = {"/opt/ros/jazzy": machine.opt_ros, "/usr/bin/python3": machine.bin / "system-python3"}
    for ours, theirs in elsewhere.items():
        assert f"={ours}\n" in text
        text = text.replace(f"={ours}\n", f"={theirs}\n")
    (machine.clone / "ros2course").write_text(text)
    (machine.clone / "ros2course").chmod(0o755)
    (machine.clone / "pyproject.toml").write_text("[project]\n")
    machine.python("python3")
    machine.uname()
    yield machine
    for process in machine.running:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
