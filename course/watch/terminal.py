"""The terminal while `watch` has it: keys as they are pressed, a screen of its own; given back as it was.

Writing never waits: a terminal that takes nothing (a line that hangs) gets the newest screenful when it
listens again.
"""

from __future__ import annotations

import asyncio
import contextlib
import errno
import os
import re
import select
import sys
import termios
import tty
from collections.abc import Callable, Iterator, Sequence

from rich.control import Control
from rich.segment import ControlType

from course.errors import UsageError

# How long the last words to a terminal that takes nothing may take, in seconds.
_PATIENCE = 1.0
_MOST_KEYS = 1024
# What arrow keys and other special ones send; nothing that was typed.
_SEQUENCE = re.compile(r"\x1b(?:\[[0-?]*[ -/]*[@-~]|O.|.)?", re.DOTALL)
_HOME, _END_OF_LINE = str(Control.home()), str(Control((ControlType.ERASE_IN_LINE, 0)))
_ENTER = str(Control.alt_screen(True)) + str(Control.show_cursor(False)) + str(Control.clear())
# Some terminals have no second screen: nothing stays on their only one.
_LEAVE = str(Control.clear()) + _HOME + str(Control.show_cursor(True)) + str(Control.alt_screen(False))


def require_terminal() -> None:
    """Raises UsageError where there is no terminal that can be drawn on."""
    if not (sys.stdin.isatty() and sys.stdout.isatty()):
        what = "`watch` shows a screen and reads keys, and this is not a terminal."
        raise UsageError(what, "Run it in a terminal; elsewhere: ros2course check")
    if os.environ.get("TERM", "dumb") in ("dumb", "unknown", ""):
        what = "This terminal says that it cannot be drawn on (TERM is not set, or dumb)."
        raise UsageError(what, "Use another one, set TERM (to xterm, for example), or: ros2course check")


class Terminal:
    """Between entering and leaving its context, `watch` has the terminal."""

    def __init__(self) -> None:
        self._keys = sys.stdin.fileno()
        self._screen = sys.stdout.fileno()
        self._attributes = termios.tcgetattr(self._keys)
        self._own = _opened_anew(self._screen)
        self._unwritten = b""
        self._next: bytes | None = None
        self._last: bytes | None = None

    def __enter__(self) -> Terminal:
        self.take()
        return self

    def __exit__(self, *_: object) -> None:
        self.give_back()
        if self._own is not None:
            os.close(self._own)

    def take(self) -> None:
        """Make it ours; again after a pause."""
        _set(self._keys, _as_pressed(self._attributes))
        self._last = None
        self._next = None
        self._unwritten += _ENTER.encode()
        self._write()

    def give_back(self) -> None:
        """As it was before. A terminal that is gone is not an error."""
        self._stop_waiting()
        with contextlib.suppress(OSError):
            self._write_all(self._unwritten + _LEAVE.encode())
        self._unwritten = b""
        with contextlib.suppress(OSError, termios.error):
            _set(self._keys, self._attributes)

    @contextlib.contextmanager
    def lent(self) -> Iterator[None]:
        """Somebody else may use it meanwhile, as it was before."""
        self.give_back()
        try:
            yield
        finally:
            self.take()

    def size(self) -> tuple[int, int]:
        """Columns and lines. The last column stays free: terminals differ in what follows it."""
        with contextlib.suppress(OSError):
            size = os.get_terminal_size(self._screen)
            if size.columns and size.lines:
                return max(size.columns - 1, 1), size.lines
        return 79, 24

    def show(self, lines: Sequence[str], *, anew: bool = False) -> None:
        """Put these lines on the screen. `anew`: even if they are there already, as far as we know."""
        body = "\r\n".join(f"{line}{_END_OF_LINE}" for line in lines)
        frame = f"{_HOME}{body}".encode(errors="replace")
        if frame != self._last or anew:
            self._last = self._next = frame
            self._write()

    def pressed(self) -> str | None:
        """The keys that were pressed; "" for special ones. None when the terminal is gone."""
        try:
            data = os.read(self._keys, _MOST_KEYS)
        except OSError as error:
            return "" if error.errno in (errno.EINTR, errno.EAGAIN) else None
        return _SEQUENCE.sub("", data.decode(errors="ignore")) if data else None

    def on_keys(self, call: Callable[[], None]) -> None:
        asyncio.get_running_loop().add_reader(self._keys, call)

    def ignore_keys(self) -> None:
        asyncio.get_running_loop().remove_reader(self._keys)

    def _write(self) -> None:
        """Write as much as the terminal accepts now, and the rest later."""
        self._stop_waiting()
        while self._unwritten or self._next:
            if not self._unwritten:
                self._unwritten, self._next = self._next or b"", None
            try:
                self._unwritten = self._unwritten[os.write(self._writable, self._unwritten) :]
            except BlockingIOError:
                asyncio.get_running_loop().add_writer(self._writable, self._write)
                return
            except OSError:  # it is gone; its keys tell so, too
                self._unwritten, self._next = b"", None

    def _write_all(self, data: bytes) -> None:
        while data and select.select([], [self._writable], [], _PATIENCE)[1]:
            with contextlib.suppress(BlockingIOError):
                data = data[os.write(self._writable, data) :]

    def _stop_waiting(self) -> None:
        with contextlib.suppress(RuntimeError):  # the loop has ended
            asyncio.get_running_loop().remove_writer(self._writable)

    @property
    def _writable(self) -> int:
        return self._screen if self._own is None else self._own


def _opened_anew(descriptor: int) -> int | None:
    """Open the same terminal without blocking. The shell shares the first descriptor, which must block."""
    try:
        return os.open(os.ttyname(descriptor), os.O_WRONLY | os.O_NOCTTY | os.O_NONBLOCK | os.O_CLOEXEC)
    except OSError:  # not to be found by its name, as in some containers
        return None


def _as_pressed(attributes: list[object]) -> list[object]:
    """Keys come one by one and are not shown; Ctrl+C and Ctrl+Z are signals, as always.

    Ctrl+S, which many press to save, and in the wrong window at times, does not stop the screen.
    """
    changed = list(attributes)
    flow, flags, characters = changed[tty.IFLAG], changed[tty.LFLAG], changed[tty.CC]
    assert isinstance(flow, int) and isinstance(flags, int) and isinstance(characters, list)
    changed[tty.IFLAG] = flow & ~termios.IXON
    changed[tty.LFLAG] = (flags | termios.ISIG) & ~(termios.ECHO | termios.ICANON)
    changed[tty.CC] = list(characters)
    changed[tty.CC][termios.VMIN], changed[tty.CC][termios.VTIME] = 1, 0  # type: ignore[index]
    return changed


def _set(descriptor: int, attributes: list[object]) -> None:
    """Set it without waiting for pending output, which may be stopped."""
    while True:
        try:
            termios.tcsetattr(descriptor, termios.TCSANOW, attributes)  # type: ignore[arg-type]
            return
        except termios.error as error:
            if error.args[0] != errno.EINTR:
                raise
