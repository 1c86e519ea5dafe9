"""An interactive bash in its own terminal, which reads the learner's `.bashrc` as their own bash does.

After each command, bash shows a prompt of ours, with the command's exit code and a random word that no
output contains by chance. PROMPT_COMMAND sets it again before each prompt, after `.bashrc` was read, so the
learner's PS1 does not interfere. If these variables are read-only, or the prompt does not reach the
terminal, each command is typed between two commands that print the same word.
"""

from __future__ import annotations

import re
import secrets
import shlex
from collections.abc import Callable, Mapping
from pathlib import Path, PurePosixPath

import psutil

from course.arena.process import Process
from course.evidence.timeline import Timeline
from course.model.events import ShellPrompt, ShellRan, ShellReady, ShellStuck

START_TIME = 10.0
COMMAND_TIME = 10.0
_PROBE_TIME = 3.0
# How many lines of one command's output are kept.
MAX_LINES = 400
_RC = """\
# Read by the bash of a check in place of ~/.bashrc, which comes first.
if [ -r ~/.bashrc ]; then . ~/.bashrc; fi
unset PROMPT_COMMAND
PROMPT_COMMAND='PS1="[\\160{word} $?]
" PS0= PS2='
"""
# What is typed around a command in that case. The p is written as octal 160, so neither `set -x` nor an echo
# of the input looks like the prompt itself.
_TYPED = (
    'builtin printf "[\\160{word} start]\\n"; eval {command}; '
    'builtin printf "[\\160{word} %d typed]\\n" "$?"\n'
)

Launch = Callable[..., Process]
_SHOWN = 80


class Shell:
    """One bash. Once it is stuck, it is ended, and further commands do nothing."""

    def __init__(self, name: str, timeline: Timeline, scratch: Path) -> None:
        self.name = name
        self._timeline = timeline
        self._word = secrets.token_hex(8)
        self._prompt = re.compile(rf"(.*)\[p{self._word} (start|\d+)( typed)?\]")
        self._rc = scratch / f"{name}.rc"
        self._lines: list[str] = []
        self._code: int | None = None
        self._typing = False
        self._process: Process

    @property
    def alive(self) -> bool:
        return self._process.running

    def open(self, launch: Launch, environment: Mapping[str, str], timeout: float) -> None:
        """Start bash, and wait until it shows its first prompt."""
        self._rc.write_text(_RC.format(word=self._word), encoding="utf-8")
        # Without line editing, bash leaves the terminal as it is, so input is not echoed.
        command = ("bash", "--noediting", "--rcfile", str(self._rc), "-i")
        self._process = launch(self.name, command, environment, through=self._hear)
        if self._await_prompt(timeout):
            self._timeline.add(ShellReady(self._timeline.now(), self.name, self._printed()))
            return
        stuck, printed = why_no_prompt(self._process), self._printed()
        if stuck[0] == "waiting" and self._answers_to_typing():
            self._timeline.add(ShellReady(self._timeline.now(), self.name, printed))
        else:
            self._end(stuck, printed)

    def run(self, command: str, timeout: float = COMMAND_TIME) -> ShellRan:
        """Type one command, and wait for the next prompt.

        The result's `printed` has its output lines, standard output and errors mixed. Its `code` is None if
        no prompt appeared within `timeout` s, or the shell has ended.
        """
        began = self._timeline.now()
        if not self.alive:
            return ShellRan(began, self.name, command, (), None, began)
        self._type(command)
        if not self._await_prompt(timeout):
            self._end(why_no_prompt(self._process), self._printed())
        printed = self._printed()
        if printed[:1] == (command,):  # `stty echo` in a .bashrc echoes the input
            printed = printed[1:]
        ran = ShellRan(self._timeline.now(), self.name, command, printed, self._code, began)
        self._timeline.add(ran)
        return ran

    def close(self) -> None:
        """End the shell. Leaving `with arena.shell()` ends it, too."""
        self._process.close()

    def _hear(self, line: str) -> str | None:
        """Process a line; return the part of it that belongs to the output."""
        found = self._prompt.search(line)
        if found is None:
            self._lines.append(line)
            return line
        if found[2] == "start":
            self._lines = []
            return None
        if found[1]:
            self._lines.append(found[1])
        # A `.bashrc` that waited for input has read what we typed, and now bash shows its ordinary prompt.
        if self._typing and not found[3]:
            return found[1] or None
        self._code = int(found[2])
        self._timeline.add(ShellPrompt(self._timeline.now(), self.name, self._code))
        return found[1] or None

    def _await_prompt(self, timeout: float) -> bool:
        self._timeline.wait_until(lambda: self._code is not None or not self.alive, timeout)
        return self._code is not None

    def _answers_to_typing(self) -> bool:
        """Whether bash is listening, and only its prompt cannot be set or seen."""
        self._typing = True
        self._type(":")
        return self._await_prompt(_PROBE_TIME)

    def _type(self, command: str) -> None:
        self._lines, self._code = [], None
        around = _TYPED.format(word=self._word, command=shlex.quote(command))
        self._process.type(around if self._typing else f"{command}\n")

    def _end(self, why: tuple[str, str], printed: tuple[str, ...]) -> None:
        self.close()
        self._timeline.add(ShellStuck(self._timeline.now(), self.name, *why, printed))

    def _printed(self) -> tuple[str, ...]:
        return tuple(self._lines[:MAX_LINES])


def why_no_prompt(shell: Process) -> tuple[str, str]:
    """A reason for `ShellStuck`, and the name of the program that it is about ("" if none)."""
    if shell.flooded:
        return "flood", ""
    try:
        bash = psutil.Process(shell.pid)
        if not shell.running or bash.status() == psutil.STATUS_ZOMBIE:
            return "ended", ""
        if not PurePosixPath(bash.exe()).name.startswith("bash"):
            return "replaced", PurePosixPath(_words(bash).split()[0]).name
        program = _in_front(bash, shell.foreground())
        if program:
            return "running", program
        return ("busy" if bash.status() == psutil.STATUS_RUNNING else "waiting"), ""
    except psutil.Error:
        return "ended", ""


def _in_front(bash: psutil.Process, group: int | None) -> str | None:
    """The command in the foreground of bash's terminal; None if it is bash itself."""
    if group is not None and group != bash.pid:
        return _words(psutil.Process(group))
    children = [child for child in bash.children() if child.status() != psutil.STATUS_ZOMBIE]
    return _words(children[-1]) if children else None


def _words(process: psutil.Process) -> str:
    return " ".join(process.cmdline() or [process.name()])[:_SHOWN]
