"""A running process and what it writes."""

from __future__ import annotations

import asyncio
import contextlib
import signal
from collections.abc import Mapping
from typing import Any

from launch.child.command import startable
from launch.child.protocol import ChildProtocol, OnOutput
from launch.child.terminal import Terminal

# Output that a process leaves in its pipes is there at once; only a grandchild keeps them open for longer.
_LAST_WORDS = 0.5


class Child:
    """Made by `Child.start`. `returncode` is negative for a death by a signal."""

    def __init__(self, transport: Any, protocol: ChildProtocol, terminals: list[Terminal]) -> None:
        self._transport = transport
        self._protocol = protocol
        self._terminals = terminals
        self.pid: int = transport.get_pid()

    @classmethod
    async def start(
        cls,
        cmd: list[str],
        *,
        shell: bool,
        cwd: str | None,
        env: Mapping[str, str],
        emulate_tty: bool,
    ) -> Child:
        """Raises OSError where the program or the folder is missing."""
        protocol = ChildProtocol(streams=2)
        terminals = [Terminal(fd, protocol) for fd in (1, 2)] if emulate_tty else []
        ends = [terminal.slave for terminal in terminals] or [asyncio.subprocess.PIPE] * 2
        transport, _ = await asyncio.get_running_loop().subprocess_exec(
            lambda: protocol, *startable(cmd, shell, env), cwd=cwd, env=env, stdout=ends[0], stderr=ends[1]
        )
        for terminal in terminals:
            terminal.listen()
        return cls(transport, protocol, terminals)

    def listen(self, on_output: OnOutput) -> None:
        """Everything that the process wrote, from its start on."""
        self._protocol.listen(on_output)

    @property
    def running(self) -> bool:
        return not self._protocol.exited.is_set()

    async def wait(self) -> int:
        """The exit code, after all output was passed on."""
        await self._protocol.exited.wait()
        with contextlib.suppress(asyncio.TimeoutError):
            await asyncio.wait_for(self._protocol.silent.wait(), _LAST_WORDS)
        for terminal in self._terminals:
            terminal.close()
        code = self._transport.get_returncode()
        self._transport.close()
        return int(code)

    def send_signal(self, number: signal.Signals) -> None:
        self._transport.send_signal(number)

    def write(self, data: bytes) -> None:
        self._transport.get_pipe_transport(0).write(data)

    def kill(self) -> None:
        if self.running:
            self._transport.kill()
