"""`report`: a graded class as one page to look at."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from course.batch.class_page import PICTURES_ROOM, of_one, read_class, with_pictures
from course.batch.results import Results
from course.cli.grade import say_damaged
from course.cli.options import Options, options_of
from course.cli.session import course_of
from course.cli.signals import ended_cleanly
from course.cli.usage import examples
from course.errors import UsageError
from course.files import write_pieces
from course.model import replace
from course.report.activity import activity
from course.report.console import error_console, open_console, put
from course.report.gradebook.sheets import Names, file_stem
from course.report.page.html import class_page, learner_page

if TYPE_CHECKING:
    from course.report.page.data import ClassPage

EXAMPLES = examples(
    ("report grades/", "the class: grades/report.html"),
    ("report grades/ --out class.html", "under another name"),
    ("report grades/ --before last/", "what changed since then"),
    ("report grades/ --learners pages/", "a page for each learner"),
    ("report grades/ --learner ada", "a page for one of them"),
)


def report(
    ctx: typer.Context,
    results: Annotated[Path, typer.Argument(metavar="DIR", help="The results folder of `grade`.")],
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="FILE", help="The file to write; by default, report.html in DIR."),
    ] = None,
    learner: Annotated[
        str | None, typer.Option("--learner", metavar="ID", help="A page for this learner alone.")
    ] = None,
    learners: Annotated[
        Path | None,
        typer.Option("--learners", metavar="DIR", help="A page for each learner, without others' data."),
    ] = None,
    before: Annotated[
        Path | None,
        typer.Option("--before", metavar="DIR", help="Results of an earlier run to compare with."),
    ] = None,
    title: Annotated[
        str,
        typer.Option("--title", metavar="TEXT", help="The assignment's name. By default, that of `grade`."),
    ] = "",
) -> None:
    """Make a report page for a graded class.

    It is a single file that needs no server. It shows people and exercises to
    sort and filter, the distribution of marks, how hard each check was, and
    the most common mistakes. It also shows each submission's code, and its
    feedback with pictures of what happened.
    """
    if learners and (learner or out):
        raise UsageError("--learners makes a page for each learner.", "Leave out --learner and --out.")
    page = _page(options_of(ctx), results.absolute(), title, everybody=learner is None, who=learner)
    if before:
        with Results.look(before.absolute()) as stored:
            earlier = read_class(before.absolute(), stored, course_of(options_of(ctx))).page
        page = replace(page, before={sheet.person.id: sheet for sheet in earlier.sheets})
    if learners:
        said = f"{learners}/  {_write_each(page, learners)} pages"
    elif learner is not None:
        said = str(_write_one(page, _place_of(page, learner), out, results))
    else:
        said = str(_write_class(page, out or results / "report.html"))
    put(open_console(), said)


def _page(options: Options, folder: Path, title: str, *, everybody: bool, who: str | None) -> ClassPage:
    course = course_of(options)
    with ended_cleanly(), activity(error_console(), "Reading the results", quiet=True) as say:
        with Results.look(folder) as stored:
            found = read_class(folder, stored, course, title)
            damaged = stored.damaged()
        say_damaged(damaged, "the command that graded the class grades it again.")
        if not everybody and who is not None:
            return of_one(found, _place_of(found.page, who))
        return with_pictures(found, PICTURES_ROOM, lambda done, total: say(f"Drawing: {done} of {total}"))


def _place_of(page: ClassPage, who: str) -> int:
    found = [place for place, sheet in enumerate(page.sheets) if who in (sheet.person.id, sheet.person.name)]
    if len(found) == 1:
        return found[0]
    what = f"{len(found)} submissions are from" if found else "There is no submission from"
    raise UsageError(f"{what} {who}.", "Give the id, as in the first column of results.csv.")


def _write_class(page: ClassPage, file: Path) -> Path:
    write_pieces(file, class_page(page))
    return file


def _write_one(page: ClassPage, place: int, out: Path | None, results: Path) -> Path:
    file = out or results / f"report-{file_stem(page.sheets[place].person.id)}.html"
    write_pieces(file, [learner_page(page, place)])
    return file


def _write_each(page: ClassPage, folder: Path) -> int:
    names = Names()
    for place, sheet in enumerate(page.sheets):
        name = names.unique(file_stem(sheet.person.id))
        write_pieces(folder / f"{name}.html", [learner_page(page, place)])
    return len(page.sheets)
