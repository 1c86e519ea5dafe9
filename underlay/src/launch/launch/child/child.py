"""A running process and what it writes."""

from __future__ import annotations

import asyncio
import contextlib
import os
import signal
from collections.abc import Mapping
from typing import Any

from launch.child.command import startable
from launch.child.guard import Guard
from launch.child.protocol import ChildProtocol, OnOutput
from launch.child.terminal import Terminal
from launch.child.tree import descendants

# Output that a process leaves in its pipes is there at once; only a grandchild keeps them open for longer.
_LAST_WORDS = 0.5
# A shell is told for the sake of what it runs; other signals are for itself.
_ENDING = (signal.SIGINT, signal.SIGTERM, signal.SIGKILL)


class Child:
    """Made by `Child.start`. `returncode` is negative for a death by a signal."""

    def __init__(
        self, transport: Any, protocol: ChildProtocol, terminals: list[Terminal], guard: Guard, tree: bool
    ) -> None:
        self._transport = transport
        self._protocol = protocol
        self._terminals = terminals
        self._guard = guard
        self._tree = tree
        self.pid: int = transport.get_pid()
        guard.watch(self.pid)

    @classmethod
    async def start(
        cls,
        cmd: list[str],
        *,
        shell: bool,
        cwd: str | None,
        env: Mapping[str, str],
        emulate_tty: bool,
        guard: Guard,
    ) -> Child:
        """Raises OSError where the program or the folder is missing. A shell and what it runs are one."""
        protocol = ChildProtocol(streams=2)
        terminals = [Terminal(fd, protocol) for fd in (1, 2)] if emulate_tty else []
        ends = [terminal.slave for terminal in terminals] or [asyncio.subprocess.PIPE] * 2
        transport, _ = await asyncio.get_running_loop().subprocess_exec(
            lambda: protocol,
            *startable(cmd, shell, env),
            cwd=cwd,
            env=env,
            stdout=ends[0],
            stderr=ends[1],
            pass_fds=[guard.mark()],
        )
        for terminal in terminals:
            terminal.listen()
        return cls(transport, protocol, terminals, guard, tree=shell)

    def listen(self, on_output: OnOutput) -> None:
        """Everything that the process wrote, from its start on."""
        self._protocol.listen(on_output)

    @property
    def running(self) -> bool:
        return not self._protocol.exited.is_set()

    async def wait(self) -> int:
        """The exit code, after all output was passed on."""
        await self._protocol.exited.wait()
        self._guard.forget(self.pid)
        with contextlib.suppress(asyncio.TimeoutError):
            await asyncio.wait_for(self._protocol.silent.wait(), _LAST_WORDS)
        for terminal in self._terminals:
            terminal.close()
        code = self._transport.get_returncode()
        self._transport.close()
        return int(code)

    def send_signal(self, number: signal.Signals) -> None:
        below = descendants([self.pid]) if self._tree and number in _ENDING else []
        self._transport.send_signal(number)
        for pid in below:
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.kill(pid, number)

    def write(self, data: bytes) -> None:
        self._transport.get_pipe_transport(0).write(data)

    def kill(self) -> None:
        if self.running:
            self.send_signal(signal.SIGKILL)
