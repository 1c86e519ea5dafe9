"""A program on a pseudo-terminal: start it, listen to it, send it signals, end it.

The program has its own controlling terminal, so it behaves as it does for the learner: output comes line by
line, and Ctrl+C reaches its whole process group. Colors are removed from its lines, and the amount kept is
bounded.
"""

from __future__ import annotations

import contextlib
import os
import re
import select
import signal
import termios
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path

import psutil

from course.evidence.timeline import Timeline
from course.isolation.isolation_plan import Starter
from course.isolation.sandbox import start_here
from course.model.events import OutputCut, OutputLine, ProcessExited, ProcessStarted, SignalSent

_CHUNK = 65536
_MAX_REST = 64
_END_TIME = 2.0
MAX_LINE = 4000
CUT = f" [line cut after {MAX_LINE:,} bytes]"
MAX_TOTAL = 1024 * 1024
MAX_TAIL = 8192
# What a line costs beyond its bytes: a million empty lines add up.
_LINE_COST = 50
_CONTROL = re.compile(
    r"\x1b[\]PX^_][^\x07\x1b]*(?:\x07|\x1b\\)?"  # window titles, links and other long commands
    r"|\x1b\[[0-?]*[ -/]*[@-~]"  # colors and movements
    r"|\x1b[ -/]*[0-~]"
    r"|[\x00-\x08\x0b-\x1f\x7f-\x9f]"
)
_SETTLING = 0.5
_FOLDER = "/dev/shm/"
_DELETED = " (deleted)"


class Process:
    """One of the learner's programs, recorded on `timeline` as `name`.

    through: called with each line of output; returns the line to record, or None to drop it. descriptors:
    file descriptors that the program inherits. start: starts it in its place. Raises OSError if the program
    cannot be started.
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
        # Readable once the program has ended; it keeps its pid until we reap it.
        self._watch: int | None = os.pidfd_open(self._child.pid)
        self._watching = threading.Lock()
        self._ended = threading.Event()
        self._status = 0
        self._signalled = False
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

    @property
    def killed_by_others(self) -> bool:
        """Whether a signal ended it before we sent one."""
        return self._has_ended() and self.wait(_END_TIME) and self._status < 0 and not self._signalled

    def foreground(self) -> int | None:
        """Return the process group in the foreground of its terminal; None if there is none left."""
        try:
            return os.tcgetpgrp(self._terminal)
        except OSError:
            return None

    def interrupt(self) -> None:
        """Do what Ctrl+C does: send SIGINT to the program and its children on this terminal."""
        self.send(signal.SIGINT)

    def send(self, number: signal.Signals) -> None:
        """Send a signal to the program's process group and record it; do nothing if the program has ended.

        What counts is when the program ended, not when we noticed. Otherwise this signal would seem to have
        ended a program that had just ended by itself.
        """
        if not self.running or self._has_ended():
            return
        self._signalled = True
        self._timeline.add(SignalSent(self._timeline.now(), self.name, int(number)))
        self._signal(number)

    def type(self, text: str) -> None:
        """Type text into its terminal; do nothing if the program has ended."""
        if self.running:
            with contextlib.suppress(OSError):  # it may end, and its terminal with it, at any moment
                os.write(self._terminal, text.encode())

    def wait(self, timeout: float) -> bool:
        """Wait for it to end; return False if it is still running after `timeout` seconds.

        When it returns True, all of the program's output and its end are on the time line.
        """
        self._thread.join(timeout)
        return not self._thread.is_alive()

    def close(self) -> None:
        """End it and any processes that it left behind, and stop listening."""
        self.send(signal.SIGKILL)
        self._signal(signal.SIGKILL)
        self.wait(_END_TIME)

    def _has_ended(self) -> bool:
        with self._watching:
            return self._watch is None or bool(select.select([self._watch], [], [], 0)[0])

    def _signal(self, number: signal.Signals) -> None:
        """Signal the whole group, or only the program in the moment before it leads a group."""
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
            select.select([watch], [], [])  # nobody has the terminal open anymore; the end is near
            return True
        return watch in ready

    def _read_rest(self) -> None:
        """Read what is left in the terminal's buffer after the program's last output.

        Bounded, because a child process left behind may keep writing forever.
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
        status = self._status = self._child.reap()
        code, number = (status, None) if status >= 0 else (None, -status)
        self._ended.set()
        self._timeline.add(ProcessExited(moment, self.name, code, number))


def _open_terminal() -> tuple[int, int]:
    """Open a pseudo-terminal and return our end and the program's. It does not echo what is typed."""
    ours, theirs = os.openpty()
    os.set_inheritable(ours, False)
    settings = termios.tcgetattr(theirs)
    settings[1] &= ~termios.ONLCR  # no carriage return before each line feed
    settings[3] &= ~termios.ECHO
    termios.tcsetattr(theirs, termios.TCSANOW, settings)
    termios.tcsetwinsize(theirs, (24, 200)) if hasattr(termios, "tcsetwinsize") else None
    return ours, theirs


class LineSplitter:
    """Bytes in, finished lines out. `dropped`: the number of bytes that were not kept.

    A line longer than MAX_LINE is cut there and marked. After MAX_TOTAL, only the last MAX_TAIL bytes are
    kept, for a traceback that may end the flood; `rest` returns them.
    """

    def __init__(self) -> None:
        self.dropped = 0
        self._kept = 0
        self._open = b""
        self._tail = b""

    def feed(self, data: bytes) -> list[str]:
        """Return the lines that `data` completes."""
        if self._kept >= MAX_TOTAL:
            self._keep_tail(data)
            return []
        *lines, self._open = (self._open + data).split(b"\n")
        self._kept += len(data) + _LINE_COST * len(lines)
        if len(self._open) > 2 * MAX_LINE:
            self.dropped += len(self._open) - MAX_LINE - 1
            self._open = self._open[: MAX_LINE + 1]  # still longer than what is kept
        return [self._clean(line) for line in lines]

    def rest(self) -> list[str]:
        """Return the last line if it had no line end; after a flood, the last lines."""
        lines = (self._open + self._tail).split(b"\n")
        self._open = self._tail = b""
        return [self._clean(line) for line in (lines if lines[-1] else lines[:-1])]

    def _keep_tail(self, data: bytes) -> None:
        """The tail begins with a whole line, unless it is one very long line."""
        whole = self._open + self._tail + data
        self._open = b""
        tail = whole[-MAX_TAIL:]
        if len(tail) < len(whole):
            tail = tail[tail.find(b"\n") + 1 :]
        self.dropped += len(whole) - len(tail)
        self._tail = tail

    def _clean(self, line: bytes) -> str:
        text = _CONTROL.sub("", line[:MAX_LINE].decode("utf-8", errors="replace"))
        if len(line) <= MAX_LINE:
            return text
        self.dropped += len(line) - MAX_LINE
        return text + CUT


def started_by(pid: int) -> tuple[psutil.Process, ...]:
    """All processes below this one, right now."""
    try:
        return tuple(psutil.Process(pid).children(recursive=True))
    except psutil.NoSuchProcess:
        return ()


def still_there(processes: tuple[psutil.Process, ...]) -> tuple[tuple[int, tuple[str, ...]], ...]:
    """Pid and command of each process that is still running, after a moment's grace for those just ending."""
    _, alive = psutil.wait_procs([one for one in processes if _runs(one)], timeout=_SETTLING)
    found = ((one.pid, _command(one)) for one in alive if _runs(one))
    return tuple((pid, command) for pid, command in found if command)


def _runs(process: psutil.Process) -> bool:
    try:
        return process.is_running() and process.status() != psutil.STATUS_ZOMBIE
    except psutil.NoSuchProcess:
        return False


def _command(process: psutil.Process) -> tuple[str, ...]:
    try:
        return tuple(process.cmdline())
    except psutil.Error:
        return ()


def files_in_memory(pid: int) -> tuple[str, ...]:
    """Sorted names of the files in /dev/shm that this process, or one below it, has mapped now."""
    return tuple(sorted({name for process in _tree(pid) for name in _mapped(process)}))


def _tree(pid: int) -> list[int]:
    try:
        below = psutil.Process(pid).children(recursive=True)
    except psutil.NoSuchProcess:
        return []
    return [pid, *(process.pid for process in below)]


def _mapped(pid: int) -> Iterator[str]:
    with contextlib.suppress(FileNotFoundError, ProcessLookupError):  # it has just ended
        for line in Path(f"/proc/{pid}/maps").read_text(encoding="utf-8", errors="replace").splitlines():
            _, _, file = line.partition(_FOLDER)
            if file:
                yield file.removesuffix(_DELETED)
