"""`doctor`: what the course finds on this machine, and what to do about what is missing."""

from __future__ import annotations

import typer

from course.cli.words import examples
from course.errors import ExitCode

EXAMPLES = examples(("doctor", "what is here, and what is missing"))


def doctor(ctx: typer.Context) -> None:
    """Look at this machine: ROS 2, compilers, disk, clock.

    For whatever is missing it says exactly what to do. Ends with 4 when
    something is missing that the course needs.
    """
    from course.cli.findings import find_all
    from course.cli.options import options_of
    from course.report.console import open_console
    from course.report.machine import State, render_findings

    findings = find_all(options_of(ctx))
    render_findings(open_console(), findings)
    if any(finding.state is State.MISSING for finding in findings):
        raise typer.Exit(ExitCode.MISSING_HERE)
