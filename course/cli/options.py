"""The options that every command has."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import typer


@dataclass(frozen=True)
class Options:
    """`home` and `course` as given on the command line, or None."""

    home: Path | None = None
    course: Path | None = None


def options_of(ctx: typer.Context) -> Options:
    """The options of this call. Completion asks for them before the program's callback has run."""
    if isinstance(ctx.obj, Options):
        return ctx.obj
    given = ctx.find_root().params
    return Options(home=_path(given.get("home")), course=_path(given.get("course")))


def _path(value: object) -> Path | None:
    """While completing, a value may still be the text that was typed."""
    return Path(str(value)) if value else None
