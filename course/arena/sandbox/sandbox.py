"""Programs of a submission, started in namespaces of their own: what the grading process uses."""

from __future__ import annotations

import contextlib
import dataclasses
import json
import os
import signal
import socket
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from course.arena.sandbox.holder import holder
from course.arena.sandbox.launcher import MEMORY, PACKET, Order, as_message, start_message
from course.arena.sandbox.limits import bound_ourselves
from course.arena.sandbox.plan import Plan
from course.arena.sandbox.watchdog import Watchdog, filesystem, watching
from course.errors import OurFault


class SandboxOver(Exception):
    """A limit was reached; nothing more can be started."""


class Confined:
    """A program in the sandbox; see `course.arena.starting.Started`."""

    def __init__(self, sandbox: Sandbox, pid: int) -> None:
        self.pid = pid
        self._sandbox = sandbox
        self._code: int | None = None

    def reap(self) -> int:
        """Its exit code, or minus the signal that ended it; waits for that."""
        if self._code is None:
            self._code = int(self._sandbox.ask(as_message("reap", pid=self.pid))["code"])
        return self._code

    def send_signal(self, number: signal.Signals) -> None:
        if self._code is None:  # else the number may be another's
            with contextlib.suppress(ProcessLookupError):
                os.kill(self.pid, number)


class Sandbox:
    """A starter of programs (see `course.arena.starting`), while the namespaces are held."""

    def __init__(self, link: socket.socket, places: Sequence[str] = ()) -> None:
        """places: folders that programs need, at any place."""
        self._link = link
        self._in_memory = tuple(place for place in places if Path(place).is_relative_to(MEMORY))
        self._one_at_a_time = threading.Lock()
        self.over = False
        self.look: Callable[[], None] = lambda: None

    def __call__(
        self,
        command: Sequence[str],
        terminal: int,
        environment: Mapping[str, str],
        folder: Path,
        descriptors: Sequence[int],
        own_memory: bool = False,
    ) -> Confined:
        if self.over:
            raise SandboxOver
        kept = self._in_memory if own_memory else None
        order = Order(tuple(command), dict(environment), str(folder), tuple(descriptors), kept)
        try:
            started = self.ask(start_message(order), (terminal, *descriptors))
        except OSError as error:
            # No process can be made in namespaces whose first one is dead, nor when there are too many.
            self.look()
            if self.over:
                raise SandboxOver from error
            raise
        return Confined(self, int(started["pid"]))

    def ask(self, message: bytes, descriptors: Sequence[int] = ()) -> dict[str, Any]:
        """Raises the OSError that the launcher met, and OurFault when it is gone."""
        with self._one_at_a_time:
            self.send(message, descriptors)
            return self.receive()

    def send(self, message: bytes, descriptors: Sequence[int] = ()) -> None:
        """The first half of `ask`."""
        socket.send_fds(self._link, [message], list(descriptors))

    def receive(self) -> dict[str, Any]:
        """The second half of `ask`."""
        data = self._link.recv(PACKET)
        if not data:
            raise OurFault("the launcher of the sandbox has ended")
        answer: dict[str, Any] = json.loads(data)
        if "error" in answer:
            raise OSError(answer["errno"], answer["error"], answer["file"])
        return answer


@contextlib.contextmanager
def open_sandbox(
    plan: Plan, link: socket.socket, scratch: Path, on_breach: Callable[[str], None]
) -> Iterator[Sandbox]:
    """link: from `fork_launcher`. scratch: a file system of its own, the sandbox's user's from now on.

    on_breach: called from another thread when a limit has been reached, and all programs were killed.
    """
    bound_ourselves()
    hand_over(scratch, plan.user)
    groups = [Path(group) for group in plan.control_groups]
    sandbox = Sandbox(link, (str(scratch), *plan.shown))
    sandbox.send(as_message("prepare", plan=dataclasses.asdict(plan)))
    with holder(plan, (scratch,)) as pid:
        sandbox.receive()
        sandbox.ask(as_message("enter", holder=pid))

        def breached(limit: str) -> None:
            sandbox.over = True
            on_breach(limit)
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)  # the first of its namespace: all others go with it

        further = [Path(f"/proc/{pid}/root", name) for name in ("tmp", "dev/shm")]
        watchdog = Watchdog(plan.limits, groups, pid, filesystem(scratch, further))
        with watching(watchdog, breached) as look:
            sandbox.look = look
            yield sandbox


def hand_over(folder: Path, user: int | None) -> None:
    """All in the folder belongs to this user from now on."""
    if user is None:
        return
    os.chown(folder, user, user)
    for path, folders, files in os.walk(folder):
        for name in (*folders, *files):
            os.chown(Path(path, name), user, user, follow_symlinks=False)
