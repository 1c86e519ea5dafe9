"""`similar`: pairs of submissions whose code is alike."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Annotated

import typer

from course.cli.options import Options, options_of
from course.cli.session import course_of
from course.cli.usage import examples
from course.errors import UsageError
from course.files import write_pieces
from course.report.activity import activity
from course.report.console import error_console, open_console
from course_similar import Solutions, Wanted, find_similar
from course_similar.page import page
from course_similar.report import render_similar

if TYPE_CHECKING:
    from course_similar.comparison import Comparison

EXAMPLES = examples(
    ("similar class/", "pairs that are alike"),
    ("similar class/ --exercises 18", "only the code of one chapter"),
    ("similar class/ --out alike.html", "both sides in full, as a page"),
    ("similar class/ --with-solutions", "with the course's solutions, too"),
)


def similar(
    ctx: typer.Context,
    submissions: Annotated[
        Path,
        typer.Argument(
            metavar="DIR",
            help="A folder of submissions, each a folder or an archive; a class's zip or a roster "
            "works, too.",
        ),
    ],
    exercises: Annotated[
        str, typer.Option("--exercises", metavar="ID,...", help="Only code of these exercises.")
    ] = "",
    share: Annotated[
        int,
        typer.Option(
            "--threshold",
            metavar="PERCENT",
            min=1,
            max=100,
            help="Show pairs in which one side shares at least this much of its own code.",
        ),
    ] = 60,
    lines: Annotated[
        int, typer.Option("--lines", metavar="N", min=1, help="And with at least this many such lines.")
    ] = 10,
    most: Annotated[
        int, typer.Option("--most", metavar="N", min=1, help="Show at most this many pairs.")
    ] = 20,
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="FILE.html", help="Write a page that shows both sides in full."),
    ] = None,
    with_solutions: Annotated[
        bool, typer.Option("--with-solutions", help="Compare with the course's own solutions, too.")
    ] = False,
    without_solutions: Annotated[
        bool, typer.Option("--without-solutions", help="Ignore everything that is in these solutions.")
    ] = False,
) -> None:
    """Show submissions with similar code.

    Shows both sides of each pair. Code from starters and lessons does not
    count, and neither do names, comments and spaces. Nothing is run. Similar
    code is not a verdict: look at both sides, and ask.
    """
    _check_out(out)
    solutions = _solutions(with_solutions, without_solutions)
    wanted = Wanted(share / 100, lines, most)
    only = [name.strip() for name in exercises.split(",") if name.strip()]
    comparison = _compared(options_of(ctx), submissions, wanted, solutions, only)
    render_similar(open_console(), comparison)
    if out:
        write_pieces(out, page(comparison))


def _check_out(out: Path | None) -> None:
    if out and (out.suffix.lower() not in (".html", ".htm") or out.is_dir()):
        raise UsageError(f"{out} is not a name for a page.", "Name a file that ends in .html")


def _solutions(compared: bool, given: bool) -> Solutions:
    if compared and given:
        raise UsageError("--with-solutions and --without-solutions exclude each other.", "Give one of them.")
    return Solutions.COMPARED if compared else Solutions.GIVEN if given else Solutions.ALONE


def _compared(
    options: Options, submissions: Path, wanted: Wanted, solutions: Solutions, only: Sequence[str]
) -> Comparison:
    course = course_of(options)
    with TemporaryDirectory(prefix="ros2course-similar-") as opened:
        say: Callable[[str], None]
        with activity(error_console(), "Reading submissions", quiet=True) as say:
            return find_similar(submissions, Path(opened), course, wanted, solutions, say, only)
