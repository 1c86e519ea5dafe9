"""Errors: what happened, and what to do next; and what `doctor` found on this machine."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

from rich.console import Console
from rich.text import Text

from course.report import sanitize
from course.report.console import put, put_prose, with_code


def render_problem(console: Console, what: str, next_step: str = "") -> None:
    """What happened, and the next step. Each paragraph of the next step is wrapped on its own."""
    put_prose(console, Text.assemble(("Error: ", "bold red"), with_code(console, _sentence(what))))
    for row, line in enumerate(line for line in next_step.splitlines() if line.strip()):
        put_prose(console, with_code(console, _sentence(line)), first="      " if row else "Next: ")


def render_bug(console: Console, what: str, log: Path | None) -> None:
    """A bug in the course: one line about it, and where the details are."""
    put_prose(
        console, Text.assemble(("An error in the course, not yours: ", "bold red"), sanitize.one_line(what))
    )
    if log:
        put(console, f"The details are in {sanitize.one_line(str(log))}")


def render_our_fault(console: Console, log: Path | None) -> None:
    """After a check that ended in our error: it does not count, and where to read more."""
    put(console)
    put_prose(console, "This is an error in the course, not yours, and the attempt does not count.")
    if log:
        put(console, f"The details are in {sanitize.one_line(str(log))}")


def render_notice(console: Console, text: str) -> None:
    """A dim sentence that is not the command's result."""
    put_prose(console, Text(sanitize.paragraph(text), "dim"))


def _sentence(text: str) -> str:
    """The same form for all: a capital and a period, but no period after something to type or choose."""
    clean = sanitize.paragraph(text)
    first = clean.split(" ")[0]
    if first == "sudo":  # a command, to be copied
        return clean
    is_file = "/" in first or "_" in first or "." in first[:-1]
    said = clean if is_file else clean[:1].upper() + clean[1:]
    return said if ": " in said or said.endswith((".", "!", "?")) else f"{said}."


class State(str, Enum):
    """OK; LESS: it is missing, and things work less well; MISSING: it is needed."""

    OK = "ok"
    LESS = "less"
    MISSING = "missing"


MARKS = {State.OK: ("ok", "green"), State.LESS: ("--", "yellow"), State.MISSING: ("no", "bold red")}


@dataclass(frozen=True)
class MachineFinding:
    """One thing that was examined: what was found and, if something is wrong, what to do."""

    name: str
    state: State
    found: str
    next_step: str | None = None


def render_findings(console: Console, findings: Sequence[MachineFinding]) -> None:
    """A table of findings, with the step to take below each problem, and a last line."""
    width = max((len(finding.name) for finding in findings), default=0)
    for finding in findings:
        mark, style = MARKS[finding.state]
        lead = f"  {mark}  {finding.name.ljust(width)}  "
        _put_finding(console, lead, Text(mark, style), finding)
    put(console)
    put_prose(console, _summary(findings))


def _put_finding(console: Console, lead: str, mark: Text, finding: MachineFinding) -> None:
    found = Text(sanitize.paragraph(finding.found))
    for row, line in enumerate(found.wrap(console, max(console.width - len(lead), 20))):
        line.rstrip()
        head = Text.assemble("  ", mark, lead[4:]) if row == 0 else Text(" " * len(lead))
        put(console, Text.assemble(head, line))
    if finding.next_step:
        step = with_code(console, sanitize.paragraph(finding.next_step))
        put_prose(console, step, first=f"{' ' * len(lead)}-> ")


def _summary(findings: Sequence[MachineFinding]) -> str:
    missing = [finding.name for finding in findings if finding.state is State.MISSING]
    if missing:
        return f"Something that is needed is missing: {', '.join(missing)}."
    if any(finding.state is State.LESS for finding in findings):
        return "Everything that is needed is here."
    return "All is well."
