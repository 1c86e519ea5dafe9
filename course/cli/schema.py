"""`schema`: what editors need to check and complete the files of a course."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from course.cli.usage import examples
from course.content.schema import Kind, schema_text
from course.errors import UsageError
from course.files import write_atomic
from course.home.storage import storing
from course.spelling import did_you_mean

EXAMPLES = examples(
    ("schema", "of lesson.yaml"),
    ("schema mistakes", "of mistakes.yaml"),
    ("schema --out lesson.json", "to a file, replacing what it contains"),
)


def schema(
    file: Annotated[
        str, typer.Argument(metavar="[FILE]", help="For which file: lesson, mistakes, or alternative.")
    ] = "lesson",
    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            metavar="FILE",
            help="Write it to this file; by default, it is printed.",
            show_default=False,
        ),
    ] = None,
) -> None:
    """Show the JSON Schema of lesson.yaml and similar files.

    Editors use it to check and complete such a file, whose first line names it:
    `# yaml-language-server: $schema=../../.schema/lesson.schema.json`.
    """
    text = schema_text(_kind(file))
    if out is None:
        typer.echo(text, nl=False)
        return
    with storing(f"{out} cannot be written"):
        write_atomic(out.absolute(), text)
    print(f"Wrote {out}")


def _kind(name: str) -> Kind:
    known = [kind.value for kind in Kind]
    plain = name.removesuffix(".yaml")
    if plain not in known:
        raise UsageError(
            f"there is no schema for `{name}`{did_you_mean(plain, known)}",
            f"allowed: {', '.join(known)}",
        )
    return Kind(plain)
