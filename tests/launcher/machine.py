"""A machine made of small files: a clone with only the launcher, and a PATH with fake Pythons."""

from __future__ import annotations

import os
import select
import shutil
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

REPO = Path(__file__).parents[2]
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
        self.script("uname", f"case $1 in -s) echo {system} ;; -m) echo {machine} ;; esac")

    def script(self, name: str, body: str) -> None:
        file = self.bin / name
        file.write_text(f"#!/bin/sh\n{body}\n")
        file.chmod(0o755)

    def ros(self, prefix: Path, python: str = "3.11") -> Path:
        """Make a folder that looks like ROS 2 to the launcher."""
        marker = prefix / "share/ament_index/resource_index/packages/rclpy"
        marker.parent.mkdir(parents=True)
        marker.touch()
        (prefix / "setup.bash").touch()
        (prefix / f"lib/python{python}/site-packages/rclpy").mkdir(parents=True)
        return prefix

    def environment(self, extra: dict[str, str]) -> dict[str, str]:
        fake = str(self.fake)
        return {"PATH": str(self.bin), "HOME": fake, "FAKE": fake, "REAL_PYTHON": sys.executable, **extra}

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
        """What the Pythons were told to do: lines that begin with venv, pip, or run."""
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
