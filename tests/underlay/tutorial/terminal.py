"""A learner at a terminal: types commands at the prompt of `ros2course shell`, and reads what comes."""

from __future__ import annotations

import contextlib
import re
from dataclasses import dataclass

import pexpect
from pexpect import fdpexpect

PATIENCE = 60.0
# bash says with these when it begins to listen, and when it hands a line over to a command.
LISTENS, HANDED_OVER = "\x1b[?2004h", "\x1b[?2004l"
_PROMPT = re.escape(LISTENS) + r"\(ros2course\) ([^\r\n]*)[$#] "
_MARK = "#MARK#"
# Colors and the like, and titles of the window.
_STYLING = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]|\x1b\][^\x07]*\x07")


@dataclass(frozen=True)
class Shown:
    """What a command printed, without colors, and its exit code as `echo $?` tells it."""

    text: str
    code: int

    @property
    def lines(self) -> list[str]:
        return self.text.splitlines()

    @property
    def ends_at_ctrl_c(self) -> bool:
        """Whether nothing was printed after Ctrl+C was pressed."""
        return self.text.rstrip("\n").endswith("^C")

    def __contains__(self, text: str) -> bool:
        return text in self.text


class Terminal:
    """One terminal window with `ros2course shell` in it, `columns` wide."""

    def __init__(self, descriptor: int) -> None:
        self._child = fdpexpect.fdspawn(
            descriptor, encoding="utf-8", timeout=PATIENCE, codec_errors="replace"
        )
        self._child.delaybeforesend = None
        self.busy = True
        self._await_prompt()
        self._settings = self.run("stty -a").text

    @property
    def folder(self) -> str:
        """Where the learner is, as the prompt tells it."""
        return self._folder

    def run(self, command: str, code: int | None = 0, *, patience: float = PATIENCE) -> Shown:
        """Type a command, and wait for its end; it has to end with `code`."""
        self.begin(command)
        return self.end(code, patience=patience)

    def begin(self, command: str) -> None:
        """Type a command."""
        self.busy = True
        self._child.send(f"{command}\r")
        self._child.expect_exact(HANDED_OVER + "\r")

    def end(self, code: int | None = 0, *, patience: float = PATIENCE) -> Shown:
        """Wait until the command has ended; it has to end with `code`, if one is given.

        What it printed since the last look.
        """
        text = self._await_prompt(patience)
        self._child.send("echo $?\r")
        self._child.expect_exact(HANDED_OVER + "\r")
        shown = Shown(text, int(self._await_prompt()))
        assert code is None or shown.code == code, shown
        return shown

    def see(self, *patterns: str) -> str:
        """Wait until the running command has printed these, in this order; all of it up to there."""
        seen = ""
        for pattern in patterns:
            try:
                self._child.expect(pattern)
            except (pexpect.TIMEOUT, pexpect.EOF) as error:
                last = f"{seen}{self._child.before}"[-2000:]
                raise AssertionError(f"{pattern!r} never came; after {last!r}") from error
            seen += f"{self._child.before}{self._child.after}"
        return _plain(seen)

    def ctrl_c(self, code: int | None) -> Shown:
        """Press Ctrl+C; the command has to end with `code`."""
        self._child.send("\x03")
        return self.end(code)

    def press(self, keys: str) -> None:
        """Press keys, without Return."""
        self._child.send(keys)

    def line_after(self, keys: str) -> str:
        """The line that is in front of the learner once these keys, with Tab among them, were pressed."""
        return re.sub(r"^\(ros2course\) .*?[$#] ", "", self._tried(keys).rpartition("\n")[2])

    def listed_after(self, keys: str) -> str:
        """What is listed below the line once these keys, with Tab among them, were pressed."""
        return self._tried(keys).partition("\n")[2].rpartition("\n")[0]

    def _tried(self, keys: str) -> str:
        # bash gets to the mark when it is done with all the keys before.
        self._child.send(f"{keys}{_MARK}")
        self._child.expect_exact(_MARK)
        shown = _plain(str(self._child.before)).replace("\a", "")
        # Ctrl+U empties the line. (After Ctrl+C at this instant, bash at times keeps the line.)
        self._child.send("\x15\r")
        self._await_prompt()
        return shown

    def is_sane(self) -> bool:
        """Whether the terminal is as it was in the beginning."""
        return self.run("stty -a").text == self._settings

    @property
    def closed(self) -> bool:
        return bool(self._child.closed)

    def leave(self) -> None:
        """Type `exit`, and wait until the window closes."""
        self._child.send("exit\r")
        self._await_end()
        self.close()

    def close(self) -> None:
        """Close the window, whatever runs in it."""
        self._child.close()

    def _await_end(self) -> None:
        with contextlib.suppress(OSError):  # Linux's way to say so
            self._child.expect(pexpect.EOF)

    def _await_prompt(self, patience: float = PATIENCE) -> str:
        try:
            self._child.expect(_PROMPT, timeout=patience)
        except (pexpect.TIMEOUT, pexpect.EOF) as error:
            raise AssertionError(f"no prompt after {str(self._child.before)[-2000:]!r}") from error
        self._folder = str(self._child.match.group(1))
        self.busy = False
        return _plain(str(self._child.before))


def _plain(text: str) -> str:
    """As the screen shows it in the end: a line that was written over contains what came last."""
    lines = _STYLING.sub("", text).replace("\r\n", "\n").split("\n")
    return "\n".join(line.rstrip("\r").rpartition("\r")[2] for line in lines)


def in_order(text: str, *parts: str) -> bool:
    """Whether the text has these parts, one after the other."""
    place = 0
    for part in parts:
        place = text.find(part, place)
        assert place >= 0, f"{part!r} is missing, or comes too early, in:\n{text}"
        place += len(part)
    return True
