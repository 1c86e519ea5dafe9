"""How a program gets onto its terminal: as our own child, or in a sandbox."""

from __future__ import annotations

import signal
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Protocol

from course.arena.containment import SCRATCH

# What programs need may lie in there.
_KEPT = f"--bind-try {SCRATCH} {SCRATCH}"
_OWN_MEMORY = f"bwrap --die-with-parent --dev-bind / / --perms 1777 --tmpfs /dev/shm {_KEPT} --".split()


class Started(Protocol):
    """A program that leads a session of its own on its terminal. Its pid is its own until it is reaped."""

    pid: int

    def reap(self) -> int:
        """Its exit code, or minus the signal that ended it; waits for that."""

    def send_signal(self, number: signal.Signals) -> None:
        """To the program alone. Nothing if it has ended."""


class Starter(Protocol):
    """Starts programs. Raises OSError when one cannot be started at all."""

    def __call__(
        self,
        command: Sequence[str],
        terminal: int,
        environment: Mapping[str, str],
        folder: Path,
        descriptors: Sequence[int],
        own_memory: bool = False,
    ) -> Started:
        """terminal: becomes its controlling one. descriptors: of ours, which it inherits.

        own_memory: with a /dev/shm that it shares with nobody.
        """


class Child:
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
) -> Child:
    """As our own child, with all that we may do and see."""
    if own_memory:
        command = (*_OWN_MEMORY, *command)
    # setsid runs in the child itself: no Python between fork and exec, although this process has threads.
    return Child(
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
