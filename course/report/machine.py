"""What `doctor` found on this machine."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

from rich.console import Console
from rich.text import Text

from course.report import safe
from course.report.console import put, put_prose, with_code


class State(str, Enum):
    """OK, or LESS: works without it, not as well; or MISSING: needed."""

    OK = "ok"
    LESS = "less"
    MISSING = "missing"


MARKS = {State.OK: ("ok", "green"), State.LESS: ("--", "yellow"), State.MISSING: ("no", "bold red")}


@dataclass(frozen=True)
class Finding:
    """One thing looked at: what was found and, unless it is well, what to do."""

    name: str
    state: State
    found: str
    next_step: str | None = None


def render_findings(console: Console, findings: Sequence[Finding]) -> None:
    """A table of findings, the step to take under each that is not well, and a last line."""
    width = max((len(finding.name) for finding in findings), default=0)
    for finding in findings:
        mark, style = MARKS[finding.state]
        lead = f"  {mark}  {finding.name.ljust(width)}  "
        _put_finding(console, lead, Text(mark, style), finding)
    put(console)
    put_prose(console, _summary(findings))


def _put_finding(console: Console, lead: str, mark: Text, finding: Finding) -> None:
    found = Text(safe.paragraph(finding.found))
    for row, line in enumerate(found.wrap(console, max(console.width - len(lead), 20))):
        line.rstrip()
        head = Text.assemble("  ", mark, lead[4:]) if row == 0 else Text(" " * len(lead))
        put(console, Text.assemble(head, line))
    if finding.next_step:
        step = with_code(console, safe.paragraph(finding.next_step))
        put_prose(console, step, first=f"{' ' * len(lead)}-> ")


def _summary(findings: Sequence[Finding]) -> str:
    missing = [finding.name for finding in findings if finding.state is State.MISSING]
    if missing:
        return f"Something that is needed is missing: {', '.join(missing)}."
    if any(finding.state is State.LESS for finding in findings):
        return "Everything that is needed is here."
    return "Everything is well."
