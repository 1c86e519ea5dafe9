"""`similar`: pairs of submissions whose code is alike."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from course.cli.options import Options, options_of
from course.cli.words import examples
from course.errors import UsageError

if TYPE_CHECKING:
    from course.batch.similar import Solutions, Wanted
    from course.report.similar.model import Comparison

EXAMPLES = examples(
    ("similar class/", "pairs that are alike"),
    ("similar class/ --out alike.html", "all of both sides, as a page"),
    ("similar class/ --with-solutions", "with the course's solutions, too"),
)


def similar(
    ctx: typer.Context,
    submissions: Annotated[
        Path,
        typer.Argument(
            metavar="DIR",
            help="A folder of submissions, each a folder or an archive; a class's zip or a roster will do.",
        ),
    ],
    share: Annotated[
        int,
        typer.Option(
            "--threshold",
            metavar="PERCENT",
            min=1,
            max=100,
            help="Show a pair from this share of either one's own code on.",
        ),
    ] = 60,
    lines: Annotated[
        int, typer.Option("--lines", metavar="N", min=1, help="And from so many such lines on.")
    ] = 10,
    most: Annotated[int, typer.Option("--most", metavar="N", min=1, help="Show so many pairs.")] = 20,
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="FILE.html", help="Write a page that shows all of both sides."),
    ] = None,
    with_solutions: Annotated[
        bool, typer.Option("--with-solutions", help="Compare with the course's own solutions, too.")
    ] = False,
    without_solutions: Annotated[
        bool, typer.Option("--without-solutions", help="Let nothing count that is in these solutions.")
    ] = False,
) -> None:
    """Show submissions whose code is alike.

    Both sides are shown. What the course gives, in starters and lessons, does
    not count; neither do names, comments and blanks. Nothing is run. Alike is
    no verdict: look at both sides, and ask.
    """
    from course.batch.similar import Wanted
    from course.report.console import open_console
    from course.report.gradebook.files import write
    from course.report.similar.page import page
    from course.report.similar.terminal import render_similar

    _check_out(out)
    solutions = _solutions(with_solutions, without_solutions)
    wanted = Wanted(share / 100, lines, most)
    comparison = _compared(options_of(ctx), submissions, wanted, solutions)
    render_similar(open_console(), comparison)
    if out:
        write(out, page(comparison))


def _check_out(out: Path | None) -> None:
    if out and (out.suffix.lower() not in (".html", ".htm") or out.is_dir()):
        raise UsageError(f"{out} is no name for a page.", "Name a file that ends in .html")


def _solutions(compared: bool, given: bool) -> Solutions:
    from course.batch.similar import Solutions

    if compared and given:
        raise UsageError("--with-solutions and --without-solutions exclude each other.", "Give one of them.")
    return Solutions.COMPARED if compared else Solutions.GIVEN if given else Solutions.ALONE


def _compared(options: Options, submissions: Path, wanted: Wanted, solutions: Solutions) -> Comparison:
    from tempfile import TemporaryDirectory

    from course.batch.similar import find_similar
    from course.cli.desk import course_of
    from course.report.activity import activity
    from course.report.console import error_console

    course = course_of(options)
    with TemporaryDirectory(prefix="ros2course-similar-") as opened:
        say: Callable[[str], None]
        with activity(error_console(), "Reading submissions", quiet=True) as say:
            return find_similar(submissions, Path(opened), course, wanted, solutions, say)
