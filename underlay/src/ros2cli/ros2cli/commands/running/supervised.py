"""A child that gets every signal once and ends no later than this process."""

from __future__ import annotations

import contextlib
import math
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from types import FrameType
from typing import Any

from ros2cli.commands.running.bound import binding
from ros2cli.commands.running.witness import Witness
from ros2cli.errors import CommandError

_PASSED_ON = frozenset({signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT})
_ENDING = (signal.SIGTERM, signal.SIGHUP)  # who sends these expects us to die of them
_ONE_REQUEST = 1.0  # seconds within which the same signal again is the same request


def run_supervised(command: Sequence[str]) -> int:
    """Run the command to its end; its exit code, negative for the signal that ended it."""
    sys.stdout.flush()
    with Witness(_PASSED_ON) as witness, _Forwarding(witness) as forwarding:
        with _held_back():
            forwarding.child = _started(command)
        code = forwarding.child.wait()
    _end_as_told(forwarding.received)
    _report(code)
    return code


class _Forwarding:
    """Hands on the signals that came to this process alone, as those of `kill`.

    Ctrl+C goes to the whole process group: the child has it already, and would take a second one for
    impatience. `timeout` sends its signal to us and to the group: two in a row are one.
    """

    def __init__(self, witness: Witness) -> None:
        self._witness = witness
        self._before: dict[signal.Signals, Any] = {}
        self.child: subprocess.Popen[bytes] | None = None
        self.received: set[int] = set()
        self._reached: dict[int, float] = {}  # when a signal last got to the child

    def __enter__(self) -> _Forwarding:
        for number in _heeded():
            self._before[number] = signal.signal(number, self._handle)
        return self

    def __exit__(self, *exception: object) -> None:
        for number, handler in self._before.items():
            signal.signal(number, handler)

    def _handle(self, number: int, frame: FrameType | None) -> None:
        self.received.add(number)
        if not self._witness.saw(number) and not self._is_repeated(number) and self.child is not None:
            with contextlib.suppress(ProcessLookupError):
                self.child.send_signal(number)
        self._reached[number] = time.monotonic()

    def _is_repeated(self, number: int) -> bool:
        return time.monotonic() - self._reached.get(number, -math.inf) < _ONE_REQUEST


def _heeded() -> list[signal.Signals]:
    """Return the signals that are not ignored: under nohup the child is to ignore them as well."""
    return [number for number in _PASSED_ON if signal.getsignal(number) is not signal.SIG_IGN]


@contextlib.contextmanager
def _held_back() -> Iterator[None]:
    """Let signals wait, so that none is lost between the start of the child and our knowing of it."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, _PASSED_ON)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _started(command: Sequence[str]) -> subprocess.Popen[bytes]:
    try:
        return subprocess.Popen(command, preexec_fn=_prepared(binding()))
    except OSError as error:
        raise CommandError(f"Cannot run {error.filename or command[0]}: {error.strerror}") from None


def _prepared(bind: Callable[[], None]) -> Callable[[], None]:
    """Return what the child does first: it dies with us, and takes signals as any program does."""

    def prepare() -> None:
        bind()
        for number in _heeded():
            signal.signal(number, signal.SIG_DFL)
        signal.pthread_sigmask(signal.SIG_UNBLOCK, _PASSED_ON)

    return prepare


def _report(code: int) -> None:
    if code < 0:
        print("[ros2run]:", signal.strsignal(-code))
    elif code:
        print(f"[ros2run]: Process exited with failure {code}")


def _end_as_told(received: set[int]) -> None:
    """End by the signal that asked this process to end, as it would have without a child."""
    for number in _ENDING:
        if number in received:
            signal.signal(number, signal.SIG_DFL)
            os.kill(os.getpid(), number)
