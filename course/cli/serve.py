"""`serve`: the page of a class while it is being graded."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from course.batch.class_page import Live
from course.cli.options import options_of
from course.cli.session import course_of
from course.cli.signals import ended_cleanly
from course.cli.usage import examples
from course.report.console import error_console, open_console, put
from course.report.page.serving import serving

EXAMPLES = examples(
    ("serve grades/", "watch while `grade` fills it"),
    ("serve grades/ --port 8123", "always on the same port"),
)


def serve(
    ctx: typer.Context,
    results: Annotated[Path, typer.Argument(metavar="DIR", help="The results folder of `grade`.")],
    port: Annotated[
        int,
        typer.Option("--port", min=0, max=65535, help="By default, a free port.", show_default=False),
    ] = 0,
) -> None:
    """Show a class while it is being graded.

    It is the page of `report`, and it updates itself. Only this machine can
    open it, and only with the printed address. Nothing can be changed through
    it. Ctrl+C ends it.
    """
    live = Live(results.absolute(), course_of(options_of(ctx)))
    live.news()  # report problems with the folder here, not in a browser
    with ended_cleanly(), serving(live, port) as server:
        put(open_console(), server.address)
        put(error_console(), "Open this address in a browser on this machine. Ctrl+C ends it.")
        try:
            server.serve_forever()
        except KeyboardInterrupt:
            put(error_console(), "Stopped.")
            raise
