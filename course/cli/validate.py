"""`validate`: prove that a course does what it claims."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from course.cli.arguments import complete_exercise
from course.cli.options import options_of
from course.cli.words import examples
from course.errors import UsageError

EXAMPLES = examples(
    ("validate", "the whole course"),
    ("validate 18-publisher", "one exercise, while writing it"),
    ("validate 18 --repeat 20", "a chapter, to find what is flaky"),
    ("validate --static", "only what is written, in seconds"),
    ("validate --course my-course/", "another course"),
)


def validate(
    ctx: typer.Context,
    exercises: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[ID...]",
            help="Exercises, or numbers of chapters; all by default.",
            autocompletion=complete_exercise,
            show_default=False,
        ),
    ] = None,
    static: Annotated[bool, typer.Option("--static", help="Only look at what is written.")] = False,
    jobs: Annotated[
        int | None, typer.Option("--jobs", min=1, max=64, help="Gradings at once; by default four a core.")
    ] = None,
    repeat: Annotated[
        int, typer.Option("--repeat", metavar="K", min=1, help="Everything K times: no verdict may change.")
    ] = 1,
    junit: Annotated[
        Path | None, typer.Option("--junit", metavar="FILE", help="Write JUnit XML, too.")
    ] = None,
    mutate: Annotated[
        bool, typer.Option("--mutate", help="Weaken the graders, and see whether the mistakes notice.")
    ] = False,
) -> None:
    """Prove that a course does what it claims.

    Looks at all that is written, then grades what the course itself supplies:
    solutions and other right ways must earn all points, starters must not
    pass, and each known mistake must be caught by its check, in its words.
    Ends with 0 when nothing was found, 1 when something was, 4 when this
    machine cannot grade some exercise.
    """
    from course.cli.desk import course_of
    from course.cli.validation import Asked, mutate_graders, validate_course

    if mutate and (static or repeat > 1 or junit):
        raise UsageError("--mutate goes with none of --static, --repeat and --junit.", "Run them by turns.")
    course, wanted = course_of(options_of(ctx)), exercises or []
    if mutate:
        raise typer.Exit(mutate_graders(course, wanted, jobs))
    asked = Asked(wanted, jobs, repeat, junit.absolute() if junit else None, static)
    raise typer.Exit(validate_course(course, asked))
