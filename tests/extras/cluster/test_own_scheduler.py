"""A class with a scheduler and workers that are killed: nothing is lost or doubled."""

from __future__ import annotations

import contextlib
import os
import signal
import socket
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.batch.command import REPO, Command, graded, verdicts
from tests.batch.conftest import Lay
from tests.conftest import FIXTURES

pytest.importorskip("distributed")
pytestmark = pytest.mark.slow

PEOPLE = [f"s{n:03}" for n in range(200)]
PATIENCE = 120.0

Start = Callable[..., subprocess.Popen[str]]


@pytest.fixture
def start(tmp_path: Path) -> Iterator[Start]:
    """`start("scheduler", ...)`: a part of Dask, in its own session."""
    started: list[subprocess.Popen[str]] = []

    def of(part: str, *words: str) -> subprocess.Popen[str]:
        with (tmp_path / f"{part}{len(started)}.log").open("w") as log:
            command = [sys.executable, "-m", "distributed.cli.dask_" + part, *words]
            environment = {**os.environ, "PYTHONPATH": str(REPO)}
            options = {"stdout": log, "stderr": log, "start_new_session": True, "text": True}
            started.append(subprocess.Popen(command, cwd=tmp_path, env=environment, **options))  # type: ignore[call-overload]
        return started[-1]

    yield of
    for process in started:
        killed(process)


def killed(process: subprocess.Popen[str]) -> None:
    """With everything that it started, as after a power cut."""
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    ended(process)


def ended(process: subprocess.Popen[str]) -> int:
    """Its exit code; nothing of it stays open."""
    if process.stdout:
        process.stdout.close()
    return process.wait(PATIENCE)


class Cluster:
    """A scheduler at one address, and two workers with one grading at once each."""

    def __init__(self, start: Start) -> None:
        with socket.create_server(("127.0.0.1", 0)) as free:
            self._port = str(free.getsockname()[1])
        self.address = f"tcp://127.0.0.1:{self._port}"
        self._start = start
        self.begin()

    def begin(self) -> None:
        place = ("--host", "127.0.0.1", "--port", self._port)
        self.scheduler = self._start("scheduler", *place, "--no-dashboard")
        self.workers = [self.worker() for _ in range(2)]

    def worker(self) -> subprocess.Popen[str]:
        return self._start("worker", self.address, "--nthreads", "1", "--no-dashboard")


def test_each_part_is_killed_during_a_class(lay: Lay, tmp_path: Path, start: Start) -> None:
    cluster = Cluster(start)
    course = ("--course", str(FIXTURES / "quiz_course"))
    words = ("--cluster", cluster.address, "--no-sandbox")
    class_ = Command(lay(*PEOPLE), tmp_path / "grades", tmp_path / "tmp", words, course)

    command = class_.start()
    found = graded(command, 20, 200)
    killed(cluster.workers[0])  # one worker: the other one takes over what it had
    found += graded(command, 20, 200)
    cluster.worker()
    killed(cluster.workers[1])
    found += graded(command, 20, 200)
    killed(cluster.scheduler)  # the scheduler: the command says so, and ends
    found += graded(command, 200, 200)
    assert ended(command) == 4
    assert len(found) < 200

    cluster.begin()
    command = class_.start()
    found += graded(command, 30, 200)
    killed(command)  # the coordinator, without a chance to say goodbye
    stored = {person for person, _ in verdicts(class_.out)}
    assert stored >= {*found} and len(found) == len({*found})

    command = class_.start()
    found += graded(command, 200, 200)
    assert ended(command) == 0
    assert len(found) == len({*found})  # nothing twice
    assert {person for person, _ in verdicts(class_.out)} == {*PEOPLE}  # nothing lost
    assert len(verdicts(class_.out)) == 200
