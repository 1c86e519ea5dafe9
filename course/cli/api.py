"""`api`: what graders can use, by name."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from course.authoring.api_reference import Entry, Reference, as_markdown, as_page
from course.cli.usage import examples
from course.files import write_atomic
from course.home.storage import storing
from course.report.console import open_console, put, put_prose
from course.report.markdown import put_markdown

EXAMPLES = examples(
    ("api", "all names"),
    ("api recording.topic", "what it takes and what it returns"),
    ("api expect_period", "what it expects"),
    ("api --out api.md", "the whole reference, as a page"),
)


def api(
    name: Annotated[
        str | None,
        typer.Argument(metavar="[NAME]", help="The full name, or its last part.", show_default=False),
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="FILE", help="Write it all to this file.", show_default=False),
    ] = None,
) -> None:
    """Show what a grader can call, and what it gets back.

    Everything in `course.api`: the arena, the recording, the `expect_*` functions,
    and what each of them returns.
    """
    reference = Reference()
    if out is not None:
        with storing(f"{out} cannot be written"):
            write_atomic(out.absolute(), as_page(reference))
        print(f"Wrote {out}")
    elif name is None:
        _list(reference)
    else:
        for entry in reference.named(name):
            _show(reference, entry)


def _list(reference: Reference) -> None:
    console = open_console()
    for title, entries in reference.sections.items():
        put(console, title, "bold")
        for entry in entries:
            put_prose(console, entry.line, first="  ", rest="      ")
            for member in entry.members if entry.name.islower() else ():
                put_prose(console, member.line, first="    ", rest="        ")


def _show(reference: Reference, entry: Entry) -> None:
    """Show one entry, and below it the type that it returns."""
    console = open_console()
    put_markdown(console, f"### {entry.name}\n\n{as_markdown(entry)}")
    for given in entry.gives:
        put(console)
        put_markdown(console, f"{as_markdown(reference.named(given)[0])}")
