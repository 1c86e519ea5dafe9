"""`watch` on a terminal that can be looked at, with a check that does what the learner's file says."""

from __future__ import annotations

import contextlib
import os
import shlex
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pexpect
import psutil
import pyte
import pytest

from course.content import Exercise, open_course
from course.home import create_home
from tests.processes import words_of
from tests.watch.pretended import LIGHT

REPO = Path(__file__).parents[2]
PATIENCE = 60.0
KEYS = "q quit"  # in the screen's last line
REAL = """
from course.cli.main import run
run()
"""
PROGRAM = """
import course.watch.checks
course.watch.checks.WORKER = "tests.watch.pretended"
from course.cli.main import run
run()
"""


class Seat:
    """A learner at a terminal of 80x24 in which a shell script runs `watch`.

    The script notes the terminal's settings before and after, and `watch`'s exit code.
    """

    def __init__(self, folder: Path, course: Path, home: Path) -> None:
        self.folder = folder
        self.home = home
        self.course = course
        self.script = PROGRAM
        self.screen = pyte.Screen(80, 24)
        self._stream = pyte.ByteStream(self.screen)
        self.raw = b""
        self._child: pexpect.spawn[bytes] | None = None

    def command(self, *words: str) -> str:
        return shlex.join([sys.executable, "-c", self.script, "--course", str(self.course), "watch", *words])

    def sit_down(self, *words: str, environment: dict[str, str] | None = None) -> None:
        """Run it, until it shows its keys."""
        script = f"""
trap : INT HUP
stty -g >before
{self.command(*words)} 2>errors
echo $? >code
stty -g >after
"""
        self.spawn(["/bin/sh", "-c", script], environment)
        self.see(KEYS)

    def quit(self) -> None:
        self.child.send("q")
        assert self.ended() == 0

    def spawn(self, command: list[str], environment: dict[str, str] | None = None) -> None:
        kept = {
            name: value for name, value in os.environ.items() if name not in ("NO_COLOR", "COLUMNS", "LINES")
        }
        self._child = pexpect.spawn(
            command[0],
            command[1:],
            env={
                **kept,
                "PYTHONPATH": str(REPO),
                "ROS2COURSE_HOME": str(self.home),
                "TERM": "xterm-256color",
                "PS1": "prompt> ",
                **(environment or {}),
            },
            cwd=str(self.folder),
            timeout=PATIENCE,
            dimensions=(24, 80),
        )

    @property
    def child(self) -> pexpect.spawn[bytes]:
        assert self._child is not None
        return self._child

    def text(self) -> str:
        return "\n".join(self.screen.display)

    def see(self, *texts: str) -> None:
        """Wait until all of these are on the screen."""
        self.wait(lambda: all(text in self.text() for text in texts), f"{texts} on the screen")

    def wait(self, condition: Callable[[], bool], what: str) -> None:
        """Look at the terminal until it is so."""
        deadline = time.monotonic() + PATIENCE
        while not condition():
            assert time.monotonic() < deadline, f"never came: {what}\n{self.text()}\n{self.errors()}"
            if not self._look() and not condition():
                raise AssertionError(f"it ended before: {what}\n{self.text()}\n{self.errors()}")

    def _look(self) -> bool:
        try:
            data = self.child.read_nonblocking(65536, timeout=0.2)
        except pexpect.TIMEOUT:
            return True
        except pexpect.EOF:
            return False
        self.raw += data
        self._stream.feed(data)
        return True

    def resize(self, rows: int, columns: int) -> None:
        self.screen.resize(rows, columns)
        self.child.setwinsize(rows, columns)

    def save(self, text: str, name: str = LIGHT) -> None:
        """At once, so that it is one save however busy the machine is."""
        file = self.home / name
        beside = file.with_name(f".{file.name}.new")
        beside.write_text(f"{text}\n")
        beside.replace(file)

    def calls(self) -> list[str]:
        file = self.folder / "calls"
        return file.read_text().splitlines() if file.exists() else []

    def errors(self) -> str:
        file = self.folder / "errors"
        return file.read_text() if file.exists() else ""

    def program(self) -> psutil.Process:
        """The process of `watch` itself."""
        return next(
            process
            for process in psutil.Process(self.child.pid).children(recursive=True)
            if self.script in words_of(process)
        )

    def ended(self) -> int:
        """Wait for its end; return its exit code. The terminal must be as before, with no process left."""
        everyone = psutil.Process(self.child.pid).children(recursive=True)
        self.wait(lambda: (self.folder / "after").exists() and not self._look(), "its end")
        self.child.close()
        assert psutil.wait_procs(everyone, timeout=PATIENCE)[1] == [], "processes are left"
        before, after = (self.folder / name for name in ("before", "after"))
        assert after.read_text() == before.read_text(), "the terminal's settings are as they were"
        self.is_given_back()
        return int((self.folder / "code").read_text())

    def is_given_back(self) -> None:
        for taken, given in ((b"\x1b[?1049h", b"\x1b[?1049l"), (b"\x1b[?25l", b"\x1b[?25h")):
            assert self.raw.rfind(given) > self.raw.rfind(taken) >= 0, (
                "the screen and the cursor are as before"
            )

    def leave(self) -> None:
        if self._child is not None:
            with contextlib.suppress(OSError):  # a test has closed the terminal
                self._child.close(force=True)


@pytest.fixture
def seat(tmp_path: Path, small_course: Path) -> Iterator[Seat]:
    home = create_home(tmp_path / "home").path
    one = Seat(tmp_path, small_course, home)
    yield one
    one.leave()


@pytest.fixture
def light(small_course: Path) -> Exercise:
    return open_course(small_course).exercise("04-light")
