"""A program on a pseudo-terminal: started, listened to, signalled, ended.

The program gets a terminal of its own as its controlling one, so it behaves as it does in
front of the learner: output comes line by line, Ctrl+C reaches its whole process group.
"""

from __future__ import annotations

import contextlib
import os
import select
import signal
import termios
import threading
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from course.arena.output import LineSplitter
from course.arena.starting import Starter, start_here
from course.evidence.events import OutputCut, OutputLine, ProcessExited, ProcessStarted, SignalSent
from course.evidence.timeline import Timeline

_CHUNK = 65536
_MAX_REST = 64


class Process:
    """One program of the learner's, recorded on `timeline` under `name`.

    through: each line of its output goes through this on its way to the recording; None drops it.
    descriptors: of ours, which the program inherits. start: where it runs. Raises OSError when it cannot
    be started at all.
    """

    def __init__(
        self,
        name: str,
        command: Sequence[str],
        *,
        env: Mapping[str, str],
        cwd: Path,
        timeline: Timeline,
        through: Callable[[str], str | None] = str,
        descriptors: Sequence[int] = (),
        start: Starter = start_here,
    ) -> None:
        self.name = name
        self._through = through
        self._timeline = timeline
        self._splitter = LineSplitter()
        self._terminal, program_side = _open_terminal()
        timeline.add(ProcessStarted(timeline.now(), name, tuple(command)))
        try:
            self._child = start(command, program_side, env, cwd, descriptors)
        except OSError:
            os.close(self._terminal)
            raise
        finally:
            os.close(program_side)
        # Readable once it has ended; it keeps its pid until we take note of that.
        self._watch: int | None = os.pidfd_open(self._child.pid)
        self._watching = threading.Lock()
        self._ended = threading.Event()
        self._thread = threading.Thread(
            target=self._follow, args=(self._watch,), name=f"process {name}", daemon=True
        )
        self._thread.start()

    @property
    def pid(self) -> int:
        return self._child.pid

    @property
    def running(self) -> bool:
        return not self._ended.is_set()

    @property
    def flooded(self) -> bool:
        """Whether it wrote more than is kept."""
        return self._splitter.dropped > 0

    def foreground(self) -> int | None:
        """The process group that holds its terminal; None when nobody does any more."""
        try:
            return os.tcgetpgrp(self._terminal)
        except OSError:
            return None

    def interrupt(self) -> None:
        """What Ctrl+C does: SIGINT to the program and its children on this terminal."""
        self.send(signal.SIGINT)

    def send(self, number: signal.Signals) -> None:
        """Send a signal to the program's process group; recorded. Nothing if it has ended.

        Its end counts from the moment it happens, not from when we took note of it: else a
        program that ended by itself just now would seem to have been ended by this signal.
        """
        if not self.running or self._has_ended():
            return
        self._timeline.add(SignalSent(self._timeline.now(), self.name, int(number)))
        self._signal(number)

    def type(self, text: str) -> None:
        """Type on its terminal. Nothing if it has ended."""
        if self.running:
            with contextlib.suppress(OSError):  # it may end, and its terminal with it, at any moment
                os.write(self._terminal, text.encode())

    def wait(self, timeout: float) -> bool:
        """Wait for its end; False when it still runs after `timeout` seconds.

        True also means that all it wrote, and its end, are on the time line.
        """
        self._thread.join(timeout)
        return not self._thread.is_alive()

    def close(self) -> None:
        """End it and what it left behind, and stop listening."""
        self.send(signal.SIGKILL)
        self._signal(signal.SIGKILL)
        self.wait(2.0)

    def _has_ended(self) -> bool:
        with self._watching:
            return self._watch is None or bool(select.select([self._watch], [], [], 0)[0])

    def _signal(self, number: signal.Signals) -> None:
        """To the whole group; to the program alone in its first moment, before it leads one."""
        try:
            os.killpg(self._child.pid, number)
        except ProcessLookupError:
            self._child.send_signal(number)

    def _follow(self, watch: int) -> None:
        try:
            while not self._read_until_exit(watch):
                pass
            self._read_rest()
        finally:
            self._record_end()
            os.close(self._terminal)
            with self._watching:
                os.close(watch)
                self._watch = None

    def _read_until_exit(self, watch: int) -> bool:
        """Read once; True as soon as the program has ended or its terminal is closed."""
        ready, _, _ = select.select([self._terminal, watch], [], [])
        if self._terminal in ready and not self._read_once():
            select.select([watch], [], [])  # nobody holds the terminal any more; the end is near
            return True
        return watch in ready

    def _read_rest(self) -> None:
        """What the program wrote last is still in the terminal's buffer.

        Bounded: a child that it left behind may go on writing for ever.
        """
        for _ in range(_MAX_REST):
            if not select.select([self._terminal], [], [], 0)[0] or not self._read_once():
                return

    def _read_once(self) -> bool:
        try:
            data = os.read(self._terminal, _CHUNK)
        except OSError:  # EIO: the last holder of the terminal closed it
            return False
        moment = self._timeline.now()
        self._record(moment, self._splitter.feed(data))
        return bool(data)

    def _record(self, moment: float, lines: Sequence[str]) -> None:
        for text in map(self._through, lines):
            if text is not None:
                self._timeline.add(OutputLine(moment, self.name, text))

    def _record_end(self) -> None:
        moment = self._timeline.now()
        self._record(moment, self._splitter.rest())
        if self._splitter.dropped:
            self._timeline.add(OutputCut(moment, self.name, self._splitter.dropped))
        status = self._child.reap()
        code, number = (status, None) if status >= 0 else (None, -status)
        self._ended.set()
        self._timeline.add(ProcessExited(moment, self.name, code, number))


def _open_terminal() -> tuple[int, int]:
    """A pseudo-terminal: our side, the program's side. It does not echo what is typed."""
    ours, theirs = os.openpty()
    os.set_inheritable(ours, False)
    settings = termios.tcgetattr(theirs)
    settings[1] &= ~termios.ONLCR  # no carriage return before each line feed
    settings[3] &= ~termios.ECHO
    termios.tcsetattr(theirs, termios.TCSANOW, settings)
    termios.tcsetwinsize(theirs, (24, 200)) if hasattr(termios, "tcsetwinsize") else None
    return ours, theirs
