"""What is expected of an interactive bash that reads the learner's `.bashrc`."""

from __future__ import annotations

import re

from course.errors import OurFault
from course.evidence.events import ShellRan, ShellStuck
from course.evidence.recording import Recording
from course.feedback import Failure, Feedback, Location

BASHRC = ".bashrc"
_COMPLAINT = re.compile(r"\.bashrc: line (?P<line>\d+): (?P<what>.*)")
_LAST_LINES = 6
_STUCK = {
    "ended": (
        "bash ends while it reads `~/.bashrc`, so no terminal would stay open.",
        "Look for `exit` in it, and take it out.",
    ),
    "replaced": (
        "`~/.bashrc` replaces bash with `{program}`, so its other lines are never read.",
        "Look for `exec` in it, and take it out.",
    ),
    "running": (
        "`~/.bashrc` does not come to an end: it runs `{program}`, and waits for that.",
        "Take out the line that starts it. What stands in `.bashrc` runs each time a terminal opens.",
    ),
    "waiting": (
        "`~/.bashrc` does not come to an end: bash waits for somebody to type.",
        "Look for `read` in it, or for a command that asks something, and take it out.",
    ),
    "busy": (
        "`~/.bashrc` does not come to an end: bash is busy with it forever.",
        "Look for a loop in it, or for a line that reads `.bashrc` itself, and take it out.",
    ),
    "flood": (
        "`~/.bashrc` prints without end.",
        "Take out the line that prints. What stands in `.bashrc` runs each time a terminal opens.",
    ),
}


def expect_shell(recording: Recording, name: str = "bash") -> None:
    """bash read `~/.bashrc` without complaint about its syntax, and showed a prompt."""
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
    """The shell came back to its prompt after this command; returns what it printed, and its code."""
    expect_shell(recording, name)
    shell = recording.shell(name)
    ran = shell.command(command)
    if ran is None and shell.stuck is None:
        raise OurFault(f"the scenario never typed `{command}`")
    if ran is None or ran.code is None:
        raise Failure(_no_return(command, shell.stuck))
    return ran


def complaints(recording: Recording, name: str = "bash") -> tuple[tuple[Location | None, str], ...]:
    """What bash said while it read `.bashrc`: the line there, where it names one, and the words."""
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
        advice="Look at this line and those before it: is the second one of two quotation marks or "
        "brackets missing?",
    )


def _no_return(command: str, stuck: ShellStuck | None) -> Feedback:
    if stuck and stuck.reason == "ended":
        return Feedback(
            summary=f"bash closes at once when `{command}` is typed.",
            where=(Location(BASHRC),),
            advice="Look for `set -e` in `~/.bashrc`: with it, the first command that fails closes bash.",
            details=stuck.printed[-_LAST_LINES:],
        )
    doing = f" `{stuck.program}` still runs." if stuck and stuck.program else ""
    return Feedback(
        summary=f"`{command}` does not come to an end.{doing}",
        where=(Location(BASHRC),),
        advice="Does it call itself, or wait for something to be typed?",
        details=stuck.printed[-_LAST_LINES:] if stuck else (),
    )
