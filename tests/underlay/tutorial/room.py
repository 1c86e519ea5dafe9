"""A room with terminals: all of them in one network that nobody else is in."""

from __future__ import annotations

import contextlib
import json
import os
import secrets
import socket
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping
from pathlib import Path

import psutil

from course.isolation.levels import isolated
from tests.processes import words_of
from tests.underlay.tutorial.terminal import Terminal

REPOSITORY = Path(__file__).parents[3]
_OPENER = Path(__file__).with_name("opener.py")
# Nothing of the tests' own environment is in the way: PYTHONPATH is not set, as with a learner.
_PROGRAM = f"import sys; sys.path.insert(0, {str(REPOSITORY)!r}); from course.cli.main import run; run()"
COURSE = (sys.executable, "-I", "-c", _PROGRAM)
_MARK = "TUTORIAL_ROOM"
_COMING, _GOING = 30.0, 10.0


class Room:
    """Opens windows with terminals in the course home `home`."""

    def __init__(self, link: socket.socket, home: Path, environment: Mapping[str, str]) -> None:
        self.home = home
        self._link = link
        self._environment = {**environment, _MARK: secrets.token_hex(8)}
        self._terminals: list[Terminal] = []

    def terminal(self, *, rows: int = 50, columns: int = 200) -> Terminal:
        """Open a window in which `ros2course shell` runs."""
        request = {
            "command": [*COURSE, "--home", str(self.home), "shell"],
            "environment": self._environment,
            "cwd": str(self.home.parent),
            "rows": rows,
            "columns": columns,
        }
        self._link.send(json.dumps(request).encode())
        _, (descriptor,), *_ = socket.recv_fds(self._link, 64, 1)
        terminal = Terminal(descriptor)
        self._terminals.append(terminal)
        return terminal

    def programs(self) -> list[psutil.Process]:
        """All that was started in the room's windows and still runs."""
        return [process for process in psutil.process_iter() if self._is_from_here(process)]

    def running(self, word: str) -> list[psutil.Process]:
        """Those of them that have this word in their command line."""
        return [process for process in self.programs() if word in words_of(process)]

    def await_program(self, word: str) -> None:
        """Wait until there is one."""
        end = time.monotonic() + _COMING
        while not self.running(word):
            assert time.monotonic() < end, f"{word} was never started"
            time.sleep(0.005)

    def await_status(self, word: str, status: str) -> None:
        """Wait until all of them are in this state: each gets there when it has its turn."""
        end = time.monotonic() + _COMING
        while (found := {one.status() for one in self.running(word)}) != {status}:
            assert time.monotonic() < end, found
            time.sleep(0.005)

    def leave(self) -> None:
        """End the ros2 daemon and close all windows; nothing may be left running after that.

        A window in which something still runs is closed over its head.
        """
        self.terminal().run("ros2 daemon stop")
        for terminal in self._terminals:
            if terminal.busy:
                terminal.close()
            elif not terminal.closed:
                assert terminal.is_sane()
                terminal.leave()
        _, left = psutil.wait_procs(self.programs(), _GOING)
        assert not left, [words_of(process) for process in left]

    def _is_from_here(self, process: psutil.Process) -> bool:
        try:
            return (
                process.environ().get(_MARK) == self._environment[_MARK]
                and process.status() != psutil.STATUS_ZOMBIE
            )
        except psutil.Error:
            return False


@contextlib.contextmanager
def open_room(home: Path, scratch: Path) -> Iterator[Room]:
    """A room. Everything in it ends with the block. `scratch` plays the learner's real home."""
    here, there = socket.socketpair()
    with here, there, isolated() as around:
        command = [*around.prefix, sys.executable, str(_OPENER), str(there.fileno())]
        with subprocess.Popen(command, pass_fds=[there.fileno()]) as opener:
            there.close()
            try:
                yield Room(here, home, {**_logged_in(scratch), **around.environment})
            finally:
                here.close()
                opener.wait(_GOING)


def _logged_in(scratch: Path) -> Mapping[str, str]:
    """The environment of a learner who has just logged in."""
    return {
        "HOME": str(scratch),
        "USER": "learner",
        "LOGNAME": "learner",
        "LANG": "C.UTF-8",
        "TERM": "xterm-256color",
        "PATH": "/usr/local/bin:/usr/bin:/bin",
        "ROS2COURSE_CACHE": os.environ["ROS2COURSE_CACHE"],
    }
