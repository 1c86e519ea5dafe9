"""Why a bash on a terminal shows no prompt: what runs there in its place, or what it waits for."""

from __future__ import annotations

from pathlib import PurePosixPath

import psutil

from course.arena.process import Process

_SHOWN = 80


def why_no_prompt(shell: Process) -> tuple[str, str]:
    """A reason as `ShellStuck` knows them, and the name of the program that it is about ("" if none)."""
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
    """The command that holds bash's terminal; None when bash itself does."""
    if group is not None and group != bash.pid:
        return _words(psutil.Process(group))
    children = [child for child in bash.children() if child.status() != psutil.STATUS_ZOMBIE]
    return _words(children[-1]) if children else None


def _words(process: psutil.Process) -> str:
    return " ".join(process.cmdline() or [process.name()])[:_SHOWN]
