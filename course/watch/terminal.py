"""The terminal while `watch` uses it: keys arrive one by one, on a separate screen; restored at the end.

Writing never waits: a terminal that accepts nothing (a hanging connection) gets the newest screenful when it
accepts data again.
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

# How long to wait, in seconds, for a terminal that does not accept the last output.
_PATIENCE = 1.0
_MOST_KEYS = 1024
# What arrow keys and other special keys send.
_SEQUENCE = re.compile(r"\x1b(?:\[[0-?]*[ -/]*[@-~]|O.|.)?", re.DOTALL)
_HOME, _END_OF_LINE = str(Control.home()), str(Control((ControlType.ERASE_IN_LINE, 0)))
_ENTER = str(Control.alt_screen(True)) + str(Control.show_cursor(False)) + str(Control.clear())
# Some terminals have no second screen, so clear the only one.
_LEAVE = str(Control.clear()) + _HOME + str(Control.show_cursor(True)) + str(Control.alt_screen(False))


def require_terminal() -> None:
    """Raises UsageError if there is no terminal that `watch` can draw on."""
    if not (sys.stdin.isatty() and sys.stdout.isatty()):
        what = "`watch` shows a screen and reads keys, and this is not a terminal."
        raise UsageError(what, "Run it in a terminal; elsewhere, run: ros2course check")
    if os.environ.get("TERM", "dumb") in ("dumb", "unknown", ""):
        what = "This terminal says that it cannot be drawn on (TERM is not set, or dumb)."
        raise UsageError(what, "Use another terminal, set TERM to xterm, or run: ros2course check")


class Terminal:
    """A context manager: inside its context, `watch` has the terminal."""

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
        """Make it ours, at the beginning and after a pause."""
        _set(self._keys, _as_pressed(self._attributes))
        self._last = None
        self._next = None
        self._unwritten += _ENTER.encode()
        self._write()

    def give_back(self) -> None:
        """Restore it. A terminal that is gone is not an error."""
        self._stop_waiting()
        with contextlib.suppress(OSError):
            self._write_all(self._unwritten + _LEAVE.encode())
        self._unwritten = b""
        with contextlib.suppress(OSError, termios.error):
            _set(self._keys, self._attributes)

    @contextlib.contextmanager
    def lent(self) -> Iterator[None]:
        """Restore it during the context, so that something else can use it."""
        self.give_back()
        try:
            yield
        finally:
            self.take()

    def size(self) -> tuple[int, int]:
        """Columns and lines. The last column stays free: terminals differ in what they do after it."""
        with contextlib.suppress(OSError):
            size = os.get_terminal_size(self._screen)
            if size.columns and size.lines:
                return max(size.columns - 1, 1), size.lines
        return 79, 24

    def show(self, lines: Sequence[str], *, anew: bool = False) -> None:
        """Put these lines on the screen. `anew`: even if they should already be there."""
        body = "\r\n".join(f"{line}{_END_OF_LINE}" for line in lines)
        frame = f"{_HOME}{body}".encode(errors="replace")
        if frame != self._last or anew:
            self._last = self._next = frame
            self._write()

    def pressed(self) -> str | None:
        """The keys that were pressed; "" for special ones. None if the terminal is gone."""
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
            except OSError:  # it is gone; reading keys will notice that, too
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
    except OSError:  # it has no usable name, as in some containers
        return None


def _as_pressed(attributes: list[object]) -> list[object]:
    """Keys arrive one by one and are not shown; Ctrl+C and Ctrl+Z are signals, as always.

    Ctrl+S does not stop the screen: many people press it to save, sometimes in the wrong window.
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
    """Set the attributes without waiting for pending output, which may be stopped."""
    while True:
        try:
            termios.tcsetattr(descriptor, termios.TCSANOW, attributes)  # type: ignore[arg-type]
            return
        except termios.error as error:
            if error.args[0] != errno.EINTR:
                raise
