"""Running a program that may hang, flood or fork, so that all of it ends when it must.

It gets a session of its own. When it ends, is called off, or runs too long, that whole session is killed.
When we ourselves are killed, the kernel tells a small guard process, which kills the session.
"""

from __future__ import annotations

import os
import selectors
import shutil
import signal
import subprocess
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from enum import Enum
from pathlib import Path
from typing import BinaryIO

from course.build.interrupt import Interrupt, Interrupted

MOST_OUTPUT = 32 * 1024**2

# Killing process group 0 means one's own: the guard leads the session, so all of it goes.
_GUARD = 'trap "kill -KILL 0" TERM; "$@" & wait "$!"'


class Ending(Enum):
    """Why a program is over."""

    EXITED = "exited"
    TOO_LONG = "too long"
    TOO_MUCH_OUTPUT = "too much output"


@dataclass(frozen=True)
class Ended:
    """`code` is the exit code; only meaningful if it EXITED by itself."""

    ending: Ending
    code: int
    seconds: float


def run(
    command: Sequence[str],
    *,
    cwd: Path,
    env: Mapping[str, str],
    output: Path,
    time_limit: float,
    interrupt: Interrupt,
) -> Ended:
    """Run `command` to its end and write what it prints to the file `output`.

    Raises Interrupted when `interrupt` is set, and OSError when it cannot be started or the disk is full.
    No process of its session is alive afterwards.
    """
    began = time.monotonic()
    with output.open("wb") as log, _session(_guarded(command), cwd, env) as process:
        ending = _watch(process, log, began + time_limit, interrupt)
    return Ended(ending, process.returncode, time.monotonic() - began)


def _guarded(command: Sequence[str]) -> list[str]:
    setpriv = shutil.which("setpriv")
    if setpriv is None:  # then only a kill -9 of ours leaves the program to end by itself
        return list(command)
    return [setpriv, "--pdeathsig", "TERM", "--", "/bin/sh", "-c", _GUARD, "sh", *command]


@contextmanager
def _session(command: Sequence[str], cwd: Path, env: Mapping[str, str]) -> Iterator[subprocess.Popen[bytes]]:
    process = subprocess.Popen(
        command,
        cwd=cwd,
        env=env,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        start_new_session=True,
    )
    try:
        yield process
    finally:
        # Before wait(): as long as the leader is not reaped, nobody else can have its number.
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        if process.stdout:
            process.stdout.close()


def _watch(process: subprocess.Popen[bytes], log: BinaryIO, deadline: float, interrupt: Interrupt) -> Ending:
    """Copy output until the program ends. A background child that keeps the pipe open does not count."""
    assert process.stdout is not None
    pipe = process.stdout.fileno()
    os.set_blocking(pipe, False)
    ended = os.pidfd_open(process.pid)
    try:
        with selectors.DefaultSelector() as selector:
            for fd in (pipe, ended, *interrupt.fds):
                selector.register(fd, selectors.EVENT_READ)
            while True:
                ready = {key.fd for key, _ in selector.select(max(0.0, deadline - time.monotonic()))}
                if ready.intersection(interrupt.fds):
                    raise Interrupted
                if pipe in ready and not _copy(pipe, log):
                    selector.unregister(pipe)
                if log.tell() > MOST_OUTPUT:
                    return Ending.TOO_MUCH_OUTPUT
                if ended in ready:  # and the pipe was, too, if anything was left in it
                    return Ending.EXITED
                if time.monotonic() >= deadline:
                    return Ending.TOO_LONG
    finally:
        os.close(ended)


def _copy(pipe: int, log: BinaryIO) -> bool:
    """Copy all that is there, a pipe's worth at most; False when there is nothing (more)."""
    try:
        data = os.read(pipe, 1 << 20)
    except BlockingIOError:
        return False
    log.write(data)
    return bool(data)
