"""A submission's programs in their own namespaces, for the grading process."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import socket
import subprocess
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from course import isolation
from course.isolation.isolation_plan import IsolationPlan, bound_ourselves
from course.isolation.launcher import MEMORY, PACKET, Order, another_launcher, as_message, start_message
from course.isolation.linux import opened
from course.isolation.watchdog import Watchdog, filesystem, watching
from course.model import codec
from course.model.feedback import Spoilt

_LAUNCHER_GONE = "The process that starts programs in the sandbox was killed from outside."


class SandboxOver(Exception):
    """A limit was reached, so nothing more can be started."""


class SandboxedProgram:
    """A program in the sandbox; see `course.isolation.isolation_plan.Started`."""

    def __init__(self, sandbox: Sandbox, pid: int) -> None:
        self.pid = pid
        self._sandbox = sandbox
        self._code: int | None = None

    def reap(self) -> int:
        """Wait for its end, and return its exit code, or minus the signal that ended it."""
        if self._code is None:
            try:
                self._code = int(self._sandbox.ask(as_message("reap", pid=self.pid))["code"])
            except Spoilt:  # the code is unknown, but `require_ours` discards this run anyway
                self._code = -signal.SIGKILL
        return self._code

    def send_signal(self, number: signal.Signals) -> None:
        if self._code is None:  # otherwise the number may belong to another process
            with contextlib.suppress(ProcessLookupError):
                os.kill(self.pid, number)


class Sandbox:
    """A starter of programs (see `isolation_plan.Starter`), while the namespaces are held."""

    def __init__(self, link: socket.socket, places: Sequence[str] = ()) -> None:
        """places: folders that programs need, wherever they are."""
        self._link = link
        self._in_memory = tuple(place for place in places if Path(place).is_relative_to(MEMORY))
        self._one_at_a_time = threading.Lock()
        self.over = False
        self.look: Callable[[], None] = lambda: None
        self.is_held: Callable[[], bool] = lambda: True

    def __call__(
        self,
        command: Sequence[str],
        terminal: int,
        environment: Mapping[str, str],
        folder: Path,
        descriptors: Sequence[int],
        own_memory: bool = False,
    ) -> SandboxedProgram:
        if self.over:
            raise SandboxOver
        kept = self._in_memory if own_memory else None
        order = Order(tuple(command), dict(environment), str(folder), tuple(descriptors), kept)
        try:
            started = self.ask(start_message(order), (terminal, *descriptors))
        except OSError as error:
            # No process can start in namespaces whose first process is dead, or that have too many processes.
            self.look()
            if self.over:
                raise SandboxOver from error
            self.require_ours()
            raise
        return SandboxedProgram(self, int(started["pid"]))

    def require_ours(self) -> None:
        """Raise Spoilt if one of our own processes, on which the programs depend, was killed.

        No process of the submission can do that directly, but one that exhausts the machine may cause it.
        Call this before we end anything.
        """
        if self.over:
            return
        if not self.is_held():
            raise Spoilt("The process that keeps the sandbox was killed from outside.")
        self.ask(as_message("are you there"))

    def ask(self, message: bytes, descriptors: Sequence[int] = ()) -> dict[str, Any]:
        """Raise the OSError that the launcher met, or Spoilt if the launcher is gone."""
        with self._one_at_a_time:
            self.send(message, descriptors)
            return self.receive()

    def send(self, message: bytes, descriptors: Sequence[int] = ()) -> None:
        """The first half of `ask`."""
        try:
            socket.send_fds(self._link, [message], list(descriptors))
        except ConnectionError as error:
            raise Spoilt(_LAUNCHER_GONE) from error

    def receive(self) -> dict[str, Any]:
        """The second half of `ask`."""
        try:
            data = self._link.recv(PACKET)
        except ConnectionError:
            data = b""
        if not data:
            raise Spoilt(_LAUNCHER_GONE)
        answer: dict[str, Any] = json.loads(data)
        if "error" in answer:
            raise OSError(answer["errno"], answer["error"], answer["file"])
        return answer


class ChildProgram:
    """A program that is our own child."""

    def __init__(self, process: subprocess.Popen[bytes]) -> None:
        self.pid = process.pid
        self._process = process

    def reap(self) -> int:
        return self._process.wait()

    def send_signal(self, number: signal.Signals) -> None:
        self._process.send_signal(number)


def start_here(
    command: Sequence[str],
    terminal: int,
    environment: Mapping[str, str],
    folder: Path,
    descriptors: Sequence[int],
    own_memory: bool = False,
) -> ChildProgram:
    """Start a program as our own child, with all our rights."""
    if own_memory:
        command = isolation.ISOLATION.with_own_memory(command)
    # setsid runs in the child itself: no Python between fork and exec, although this process has threads.
    return ChildProgram(
        subprocess.Popen(
            ["setsid", "--ctty", *command],
            stdin=terminal,
            stdout=terminal,
            stderr=terminal,
            env=dict(environment),
            cwd=folder,
            pass_fds=descriptors,
        )
    )


@contextlib.contextmanager
def open_sandbox(
    plan: IsolationPlan,
    launcher: socket.socket,
    scratch: Path,
    on_breach: Callable[[str], None],
    fill: Callable[[Path], None],
) -> Iterator[tuple[Sandbox, Path]]:
    """A sandbox in which nothing has run yet, and the path by which this process reaches its scratch folder.

    launcher: from `fork_launcher`. scratch: the programs' path to that folder, which is in memory and only
    theirs. on_breach: called from another thread after a limit was reached and all programs were killed.
    fill: puts the first files into the folder.
    """
    bound_ourselves()
    with contextlib.ExitStack() as stack:
        link = stack.enter_context(another_launcher(launcher))
        sandbox = Sandbox(link, (str(scratch), *plan.shown))
        sandbox.send(as_message("prepare", plan=codec.to_json(plan).decode()))
        held = stack.enter_context(isolation.ISOLATION.hold(plan, scratch))
        pid, sandbox.is_held = held.pid, held.is_alive
        sandbox.receive()
        folder = Path("/proc/self/fd", str(stack.enter_context(opened(f"/proc/{pid}/root{scratch}"))))
        fill(folder)
        hand_over(folder, plan.user)
        sandbox.ask(as_message("enter", holder=pid))

        def breached(limit: str) -> None:
            sandbox.over = True
            on_breach(limit)
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)  # the first of its namespace: all others end with it

        groups = [Path(group) for group in plan.control_groups]
        further = [Path(f"/proc/{pid}/root", name) for name in ("tmp", "dev/shm")]
        watchdog = Watchdog(plan.limits, groups, pid, filesystem(folder, further))
        sandbox.look = stack.enter_context(watching(watchdog, breached))
        yield sandbox, folder


def hand_over(folder: Path, user: int | None) -> None:
    """Make everything in the folder belong to this user."""
    if user is None:
        return
    os.chown(folder, user, user)
    for path, folders, files in os.walk(folder):
        for name in (*folders, *files):
            os.chown(Path(path, name), user, user, follow_symlinks=False)
