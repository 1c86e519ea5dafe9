"""Expectations about an interactive bash that reads the learner's `.bashrc`."""

from __future__ import annotations

import re

from course.errors import OurFault
from course.evidence.recording import Recording
from course.model.events import ShellRan, ShellStuck
from course.model.feedback import Failure, Feedback, Location

BASHRC = ".bashrc"
_COMPLAINT = re.compile(r"\.bashrc: line (?P<line>\d+): (?P<what>.*)")
_LAST_LINES = 6
_STUCK = {
    "ended": (
        "bash exits while it reads `~/.bashrc`, so no terminal stays open.",
        "Look for `exit` in it, and remove it.",
    ),
    "replaced": (
        "`~/.bashrc` replaces bash with `{program}`, so its other lines are never read.",
        "Look for `exec` in it, and remove it.",
    ),
    "running": (
        "`~/.bashrc` never ends: it runs `{program}` and waits for it.",
        "Remove the line that starts it. Every line of `.bashrc` runs each time a terminal opens.",
    ),
    "waiting": (
        "`~/.bashrc` never ends: bash waits for input.",
        "Look for `read` in it, or for a command that asks a question, and remove it.",
    ),
    "busy": (
        "`~/.bashrc` never ends: bash is busy with it forever.",
        "Look for a loop in it, or for a line that reads `.bashrc` itself, and remove it.",
    ),
    "flood": (
        "`~/.bashrc` prints forever.",
        "Remove the line that prints. Every line of `.bashrc` runs each time a terminal opens.",
    ),
}


def expect_shell(recording: Recording, name: str = "bash") -> None:
    """Check that bash read `~/.bashrc` without syntax errors and showed a prompt."""
    shell = recording.shell(name)
    if shell.ready is None and shell.stuck is None:
        raise OurFault(f"the scenario opened no shell named {name}")
    if shell.ready is None and shell.stuck is not None:
        raise Failure(_stuck(recording, shell.stuck))
    printed = shell.ready.printed if shell.ready else ()
    broken = next((line for line in printed if "syntax error" in line or "unexpected EOF" in line), None)
    if broken:
        raise Failure(_broken(broken))


def expect_ran(recording: Recording, command: str, name: str = "bash") -> ShellRan:
    """Check that the shell returned to its prompt after this command. Returns its output and exit code."""
    expect_shell(recording, name)
    shell = recording.shell(name)
    ran = shell.command(command)
    if ran is None and shell.stuck is None:
        raise OurFault(f"the scenario never typed `{command}`")
    if ran is None or ran.code is None:
        raise Failure(_no_return(command, shell.stuck))
    return ran


def complaints(recording: Recording, name: str = "bash") -> tuple[tuple[Location | None, str], ...]:
    """Return what bash printed while reading `.bashrc`: each message's line, if known, and its text."""
    ready = recording.shell(name).ready
    return tuple(_complaint(line) for line in (ready.printed if ready else ()))


def _complaint(line: str) -> tuple[Location | None, str]:
    found = _COMPLAINT.search(line)
    if found:
        return Location(BASHRC, int(found["line"])), found["what"]
    return None, line


def _stuck(recording: Recording, stuck: ShellStuck) -> Feedback:
    summary, advice = _STUCK[stuck.reason]
    words = {"running": stuck.program, "replaced": "exec", "ended": "exit", "waiting": "read"}
    lines = recording.home.file(BASHRC).lines
    word = words.get(stuck.reason)
    places = [n for n, line in enumerate(lines, 1) if word and word in line.split("#")[0]]
    return Feedback(
        summary=summary.format(program=stuck.program),
        where=tuple(Location(BASHRC, place) for place in places[:1]) or (Location(BASHRC),),
        advice=advice,
        details=stuck.printed[:_LAST_LINES],
    )


def _broken(line: str) -> Feedback:
    where, what = _complaint(line)
    return Feedback(
        summary=f"bash cannot read all of `~/.bashrc`. It says: {what}.",
        where=(where or Location(BASHRC),),
        advice="Check this line and the lines before it: is a closing quotation mark or bracket missing?",
    )


def _no_return(command: str, stuck: ShellStuck | None) -> Feedback:
    if stuck and stuck.reason == "ended":
        return Feedback(
            summary=f"bash closes immediately when `{command}` is typed.",
            where=(Location(BASHRC),),
            advice="Look for `set -e` in `~/.bashrc`: with it, the first command that fails closes bash.",
            details=stuck.printed[-_LAST_LINES:],
        )
    doing = f" `{stuck.program}` is still running." if stuck and stuck.program else ""
    return Feedback(
        summary=f"`{command}` never ends.{doing}",
        where=(Location(BASHRC),),
        advice="Does it call itself, or wait for input?",
        details=stuck.printed[-_LAST_LINES:] if stuck else (),
    )
