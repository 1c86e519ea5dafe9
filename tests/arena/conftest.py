"""Programs on terminals, and what the time line records about them."""

from __future__ import annotations

import os
import select
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TypeVar

import pytest

from course.arena.process import Process
from course.evidence.timeline import Timeline
from course.model.events import Event, OutputLine, ProcessExited

from .programs import Programs

WAIT = 20.0  # for things that take milliseconds, on a busy machine
_E = TypeVar("_E", bound=Event)


def ended(pid: int) -> bool:
    """Wait for the end of a process that is not a child of ours."""
    try:
        watch = os.pidfd_open(pid)
    except ProcessLookupError:
        return True
    try:
        return bool(select.select([watch], [], [], WAIT)[0])
    finally:
        os.close(watch)


class Stage:
    """Starts programs on one time line; any that are left end with it."""

    def __init__(self, folder: Path, timeline: Timeline | None = None) -> None:
        self.timeline = timeline or Timeline()
        self.folder = folder
        self._processes: list[Process] = []

    def start(self, *command: str, name: str = "program", env: dict[str, str] | None = None) -> Process:
        environment = {"PATH": os.environ["PATH"]} if env is None else env
        process = Process(name, command, env=environment, cwd=self.folder, timeline=self.timeline)
        self._processes.append(process)
        return process

    def python(self, code: str, name: str = "program") -> Process:
        """`code` in a Python without site packages, which starts quickly."""
        return self.start(sys.executable, "-S", "-c", code, name=name)

    def events(self, kind: type[_E]) -> list[_E]:
        return list(self.timeline.of(kind))

    @property
    def lines(self) -> list[str]:
        return [event.text for event in self.events(OutputLine)]

    @property
    def end(self) -> ProcessExited:
        """The one end that was recorded."""
        (exited,) = self.events(ProcessExited)
        return exited

    def await_line(self, text: str) -> None:
        assert self.timeline.wait_until(lambda: text in self.lines, WAIT), self.lines

    def close(self) -> None:
        for process in self._processes:
            process.close()


@pytest.fixture
def stage(tmp_path: Path) -> Iterator[Stage]:
    stage = Stage(tmp_path)
    yield stage
    stage.close()


@pytest.fixture
def programs(tmp_path: Path) -> Iterator[Programs]:
    programs = Programs(tmp_path)
    yield programs
    programs.close()
