"""An interactive bash on a terminal of its own, which reads the learner's `.bashrc` as theirs does.

After each command bash shows a prompt of ours, with the command's exit code and a random word that no
output can hold by chance. It is set anew by PROMPT_COMMAND before each prompt, after `.bashrc` was read,
so no PS1 of the learner's gets in its way; where these are write-protected, or the prompt does not reach
the terminal, each command is typed between two words of ours.
"""

from __future__ import annotations

import re
import secrets
import shlex
from collections.abc import Callable, Mapping
from pathlib import Path

from course.arena.process import Process
from course.arena.stuck import why_no_prompt
from course.evidence.events import ShellPrompt, ShellRan, ShellReady, ShellStuck
from course.evidence.timeline import Timeline

START_TIME = 10.0
COMMAND_TIME = 10.0
_PROBE_TIME = 3.0
# What is kept of one command's output; a terminal has no more patience either.
MAX_LINES = 400
_RC = """\
# Read by the bash of a check in place of ~/.bashrc, which comes first.
if [ -r ~/.bashrc ]; then . ~/.bashrc; fi
unset PROMPT_COMMAND
PROMPT_COMMAND='PS1="[\\160{word} $?]
" PS0= PS2='
"""
# The same words, when they are typed. Until bash shows them, the p is written as octal 160: so neither
# `set -x` nor an echo of what is typed looks like the prompt itself.
_TYPED = (
    'builtin printf "[\\160{word} start]\\n"; eval {command}; '
    'builtin printf "[\\160{word} %d typed]\\n" "$?"\n'
)

Launch = Callable[..., Process]


class Shell:
    """One bash. Once it is stuck it is ended, and commands typed after that do nothing."""

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
        """Start it, and wait until it shows its first prompt."""
        self._rc.write_text(_RC.format(word=self._word), encoding="utf-8")
        # Without editing, bash leaves the terminal as it is: nothing that is typed comes back.
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

        The result's `printed` are its lines, standard output and errors as they came; its `code` is
        None when no prompt came within `timeout` s, and in a shell that has ended.
        """
        began = self._timeline.now()
        if not self.alive:
            return ShellRan(began, self.name, command, (), None, began)
        self._type(command)
        if not self._await_prompt(timeout):
            self._end(why_no_prompt(self._process), self._printed())
        printed = self._printed()
        if printed[:1] == (command,):  # `stty echo` in a .bashrc: what was typed comes back
            printed = printed[1:]
        ran = ShellRan(self._timeline.now(), self.name, command, printed, self._code, began)
        self._timeline.add(ran)
        return ran

    def close(self) -> None:
        self._process.close()

    def _hear(self, line: str) -> str | None:
        """Take note of a line; returns what of it belongs to the output."""
        found = self._prompt.search(line)
        if found is None:
            self._lines.append(line)
            return line
        if found[2] == "start":
            self._lines = []
            return None
        if found[1]:
            self._lines.append(found[1])
        # A `.bashrc` that waits for input takes what is typed to it and goes on, to the other prompt.
        if self._typing and not found[3]:
            return found[1] or None
        self._code = int(found[2])
        self._timeline.add(ShellPrompt(self._timeline.now(), self.name, self._code))
        return found[1] or None

    def _await_prompt(self, timeout: float) -> bool:
        self._timeline.wait_until(lambda: self._code is not None or not self.alive, timeout)
        return self._code is not None

    def _answers_to_typing(self) -> bool:
        """Whether bash does listen, and only its prompt cannot be set or seen."""
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
