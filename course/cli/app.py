"""The command line as a whole: options for every command, and the list of commands."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from course import __version__
from course.cli import (
    bundle,
    check,
    doctor,
    evidence,
    grade,
    hint,
    init,
    listing,
    new,
    next_,
    play,
    regrade,
    report,
    reset,
    schema,
    serve,
    shell,
    show,
    similar,
    solution,
    underlay,
    validate,
    watch,
)
from course.cli.options import Options, course_named
from course.cli.words import PROGRAM, examples

EPILOG = (
    examples(
        ("next", "begin, or go on where you left off"),
        ("check", "check the exercise you are at"),
        ("watch", "check it at every save"),
        ("hint", "a hint for it"),
        ("shell", "a shell in your course home, with ROS 2 ready"),
        ("doctor", "what is here, and what is missing"),
        ("COMMAND --help", "more about a command, with examples"),
    )
    + "\n\n\b\nExit codes: 0 passed or done, 1 not passed, 2 wrong usage,"
    + "\n3 a fault of the course, 4 something is missing here, 130 stopped with Ctrl+C."
)

app = typer.Typer(
    name=PROGRAM,
    # Plain help: quick to show, and the same with and without colour.
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"{PROGRAM} {__version__}")
        raise typer.Exit()


@app.callback(invoke_without_command=True, epilog=EPILOG)
def program(
    ctx: typer.Context,
    home: Annotated[
        Path | None,
        typer.Option("--home", metavar="DIR", help="The course home to work in.", show_default=False),
    ] = None,
    course: Annotated[
        str | None,
        typer.Option(
            "--course",
            metavar="DIR",
            help="Another course: its folder, or the name of an installed package.",
            show_default=False,
        ),
    ] = None,
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Show the version.")
    ] = False,
) -> None:
    """An interactive ROS 2 course: read, write a node, have it checked.

    Your work lies in a course home: the folder given with --home, else in the
    environment variable ROS2COURSE_HOME, else the one you are in, else
    ~/ros2course. `next` makes it when there is none. One that was made with
    --course remembers it.
    """
    ctx.obj = Options(home=home, course=course_named(course))
    if ctx.invoked_subcommand is None:
        typer.echo(ctx.get_help())


for command, name, epilog in (
    (next_.next_, "next", next_.EXAMPLES),
    (check.check, "check", check.EXAMPLES),
    (watch.watch, "watch", watch.EXAMPLES),
    (hint.hint, "hint", hint.EXAMPLES),
    (play.play, "play", play.EXAMPLES),
    (listing.list_, "list", listing.EXAMPLES),
    (show.show, "show", show.EXAMPLES),
    (reset.reset, "reset", reset.EXAMPLES),
    (solution.solution, "solution", solution.EXAMPLES),
    (init.init, "init", init.EXAMPLES),
    (shell.shell, "shell", shell.EXAMPLES),
    (shell.env, "env", shell.ENV_EXAMPLES),
    (grade.grade, "grade", grade.EXAMPLES),
    (regrade.regrade, "regrade", regrade.EXAMPLES),
    (report.report, "report", report.EXAMPLES),
    (serve.serve, "serve", serve.EXAMPLES),
    (bundle.make_bundle, "bundle", bundle.EXAMPLES),
    (similar.similar, "similar", similar.EXAMPLES),
    (new.new, "new", new.EXAMPLES),
    (schema.schema, "schema", schema.EXAMPLES),
    (validate.validate, "validate", validate.EXAMPLES),
    (doctor.doctor, "doctor", doctor.EXAMPLES),
    (underlay.build_underlay, "build-underlay", underlay.EXAMPLES),
):
    app.command(name, epilog=epilog)(command)

app.add_typer(evidence.evidence, name="evidence", epilog=evidence.EXAMPLES)
