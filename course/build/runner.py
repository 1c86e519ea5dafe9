"""Runs a program that may hang, flood or fork, so that all of it ends when it must, or when it is called off.

It gets a session of its own. When it ends, is called off, or runs too long, that whole session is killed.
If we are killed ourselves, the kernel ends an isolated program; otherwise, a small guard kills the session.
"""

from __future__ import annotations

import os
import select
import selectors
import shutil
import subprocess
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from pathlib import Path
from types import TracebackType
from typing import Any, BinaryIO

from course import isolation
from course.isolation import IsolationPlan
from course.model.feedback import Spoilt

MOST_OUTPUT = 32 * 1024**2
# How often limits are looked at, in seconds.
_LOOK = 0.25

# `kill 0` kills one's own process group. The guard leads the session, so all of it ends. If we have ended
# before the guard asked the kernel to watch us ($0 is our process id), nothing starts.
_GUARD = 'trap "kill -KILL 0" TERM; [ "$PPID" = "$0" ] || exit; "$@" & wait "$!"'


class Ending(Enum):
    """Why a program ended."""

    EXITED = "exited"
    TOO_LONG = "too long"
    TOO_MUCH_OUTPUT = "too much output"
    LIMIT = "limit"


@dataclass(frozen=True)
class Ended:
    """`code` is the exit code; only meaningful if it EXITED by itself. `limit`: which one was reached."""

    ending: Ending
    code: int
    seconds: float
    limit: str | None = None


def run(
    plan: IsolationPlan | None,
    command: Sequence[str],
    cwd: Path,
    env: Mapping[str, str],
    output: Path,
    time_limit: float,
    interrupt: Interrupt,
    breach: Callable[[int], str | None] = lambda pid: None,
) -> Ended:
    """Run `command` to its end, as the plan says, and write what it prints to the file `output`.

    breach: called now and then with the pid of what was started; returns a limit that was reached.
    Raises Interrupted when `interrupt` is set, and OSError if it cannot be started or the disk is full.
    Raises Spoilt if somebody else has killed a process of ours that it depends on.
    No process of its session is alive afterwards.
    """
    began, guarded = time.monotonic(), command if plan else _guarded(command)
    pipes: dict[str, Any] = {
        "stdin": subprocess.DEVNULL,
        "stdout": subprocess.PIPE,
        "stderr": subprocess.STDOUT,
    }
    with output.open("wb") as log, isolation.start(plan, guarded, cwd=cwd, env=env, **pipes) as started:
        watch = _Watch(started.process, log, began + time_limit, interrupt, breach)
        ending = watch.until_end()
        if ending is Ending.EXITED and not started.saw_the_end():
            raise Spoilt("A process that a build depends on was killed from outside.")
    return Ended(ending, started.process.returncode, time.monotonic() - began, watch.limit)


def _guarded(command: Sequence[str]) -> list[str]:
    setpriv = shutil.which("setpriv")
    if setpriv is None:  # then the program outlives us if we are killed with -9
        return list(command)
    return [setpriv, "--pdeathsig", "TERM", "--", "/bin/sh", "-c", _GUARD, str(os.getpid()), *command]


class _Watch:
    """Copies output until the program ends. A background child that keeps the pipe open does not count."""

    def __init__(
        self,
        process: subprocess.Popen[bytes],
        log: BinaryIO,
        deadline: float,
        interrupt: Interrupt,
        breach: Callable[[int], str | None],
    ) -> None:
        assert process.stdout is not None
        self.limit: str | None = None
        self._process = process
        self._pipe = process.stdout.fileno()
        self._log = log
        self._deadline = deadline
        self._interrupt = interrupt
        self._breach = breach
        self._look = 0.0

    def until_end(self) -> Ending:
        os.set_blocking(self._pipe, False)
        ended = os.pidfd_open(self._process.pid)
        try:
            with selectors.DefaultSelector() as selector:
                for fd in (self._pipe, ended, *self._interrupt.fds):
                    selector.register(fd, selectors.EVENT_READ)
                while True:
                    ending = self._step(selector, ended)
                    if ending is not None:
                        return ending
        finally:
            os.close(ended)

    def _is_over(self, *, last: bool) -> bool:
        if last or time.monotonic() >= self._look:
            self._look = time.monotonic() + _LOOK
            self.limit = self._breach(self._process.pid)
        return self.limit is not None

    def _step(self, selector: selectors.BaseSelector, ended: int) -> Ending | None:
        left = max(0.0, self._deadline - time.monotonic())
        ready = {key.fd for key, _ in selector.select(min(left, _LOOK))}
        if ready.intersection(self._interrupt.fds):
            raise Interrupted
        if self._pipe in ready and not _copy(self._pipe, self._log):
            selector.unregister(self._pipe)
        if self._log.tell() > MOST_OUTPUT:
            return Ending.TOO_MUCH_OUTPUT
        if self._is_over(last=ended in ready):
            return Ending.LIMIT
        if ended in ready:  # and the pipe was, too, if anything was left in it
            return Ending.EXITED
        return Ending.TOO_LONG if time.monotonic() >= self._deadline else None


def _copy(pipe: int, log: BinaryIO) -> bool:
    """Copy the available data, at most one pipe's capacity; False if there is none."""
    try:
        data = os.read(pipe, 1 << 20)
    except BlockingIOError:
        return False
    log.write(data)
    return bool(data)


class Interrupted(Exception):
    """The build was called off before it was done."""


class Interrupt:
    """A flag that can be waited for together with file descriptors: one of `fds` is readable once it is set.

    Made for threads: KeyboardInterrupt reaches only the main one, which then sets this for the others.
    When `parent` is set, this one is, too.
    """

    def __init__(self, parent: Interrupt | None = None) -> None:
        end, self._other_end = os.pipe()
        self._end = end
        self.fds: tuple[int, ...] = (end, *(parent.fds if parent else ()))

    def __enter__(self) -> Interrupt:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.set()
        os.close(self._end)

    def set(self) -> None:
        """Wake everyone who waits, now and later. Setting it twice is fine."""
        end, self._other_end = self._other_end, -1
        if end != -1:
            os.close(end)

    def wait(self, seconds: float) -> None:
        """Wait that long, or raise Interrupted as soon as it is set."""
        if select.select(self.fds, [], [], seconds)[0]:
            raise Interrupted
