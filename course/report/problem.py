"""Errors: what happened, and what to do next."""

from __future__ import annotations

from pathlib import Path

from rich.console import Console
from rich.text import Text

from course.report import safe
from course.report.console import put, put_prose, with_code


def render_problem(console: Console, what: str, next_step: str = "") -> None:
    """What happened, and the next step. Each paragraph of the next step is wrapped on its own."""
    put_prose(console, Text.assemble(("Error: ", "bold red"), with_code(console, _sentence(what))))
    for row, line in enumerate(line for line in next_step.splitlines() if line.strip()):
        put_prose(console, with_code(console, safe.paragraph(line)), first="      " if row else "Next: ")


def render_bug(console: Console, what: str, log: Path | None) -> None:
    """A bug of the course: one line about it, and where all of it was written down."""
    put_prose(console, Text.assemble(("A fault of the course, not yours: ", "bold red"), safe.one_line(what)))
    if log:
        put(console, f"The details are in {safe.one_line(str(log))}")


def render_our_fault(console: Console, log: Path | None) -> None:
    """After a check that ended in our error: it does not count, and where to read more."""
    put(console)
    put_prose(console, "This is a fault of the course, not yours, and the attempt does not count.")
    if log:
        put(console, f"The details are in {safe.one_line(str(log))}")


def render_notice(console: Console, text: str) -> None:
    """A quiet sentence that is not the command's result."""
    put_prose(console, Text(safe.paragraph(text), "dim"))


def _sentence(text: str) -> str:
    clean = safe.paragraph(text)
    return clean[:1].upper() + clean[1:] if clean[:1].islower() and "/" not in clean.split(" ")[0] else clean
