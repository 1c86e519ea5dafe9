"""`results`: marks by hand for a graded class, and its marks for your LMS."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from course.batch.class_page import ReadClass, read_class
from course.batch.intake.class_list import id_of
from course.batch.intake.people import Lms, lms_id
from course.batch.marks import FILE as MARKS
from course.batch.results import Results, people_of
from course.cli.extras import extra
from course.cli.options import options_of
from course.cli.session import course_of
from course.cli.usage import examples
from course.errors import UsageError
from course.files import write_pieces
from course.home.storage import storing
from course.report import sanitize
from course.report.console import open_console, put, put_prose
from course.report.gradebook.class_files import marks_to_review
from course.report.gradebook.letter import letter
from course.report.gradebook.lms_sheet import Score, canvas_comments, fill, moodle_feedback

if TYPE_CHECKING:
    from course.model.gradebook import Person
    from course.report.gradebook.lms_sheet import Filled
    from course.report.gradebook.sheets import Sheet
    from course.report.page.data import ClassPage

EXAMPLES = examples(
    ("results marks week3", "a file for your own marks"),
    ("results fill canvas.csv week3", "your LMS's own sheet"),
    ("results moodle week3", "the letters, for Moodle"),
    ("results canvas week3", "the letters, for Canvas"),
)
FILL_EXAMPLES = examples(
    ("results fill canvas.csv week3 --column 771", "one of several columns"),
    ("results fill worksheet.csv week3 --scale", "if the LMS has a different maximum"),
)

MOODLE_EXAMPLES = examples(("results moodle week3", "week3/moodle-feedback.zip"))
CANVAS_EXAMPLES = examples(("results canvas week3", "week3/canvas-comments.json"))
_SEND = """\
  curl -H "Authorization: Bearer $TOKEN" -H "Content-Type: application/json" -d @{} \\
    https://YOUR-CANVAS/api/v1/courses/COURSE/assignments/ASSIGNMENT/submissions/update_grades"""

results = typer.Typer(rich_markup_mode=None, add_completion=False, no_args_is_help=True)
Folder = Annotated[Path, typer.Argument(metavar="DIR", help="The results folder of `grade`.")]


@results.callback()
def about() -> None:
    """Mark a class by hand, or fill in your LMS."""


@results.command("marks", epilog=EXAMPLES)
def marks(ctx: typer.Context, folder: Folder) -> None:
    """Write a marks.yaml to fill in.

    It lists everyone, with each exercise in which they did not earn all points.
    People with equal code and equal results share an entry. Empty entries
    change nothing. `report` and `regrade` read the file.
    """
    file = folder / MARKS
    if file.exists():
        raise UsageError(f"{file} already exists, and is left as it is.", "Edit it, or move it away first.")
    found = _class(ctx, folder)
    code_of = extra("similar", "tokens").code_of
    pieces = marks_to_review(found.page.sheets, lambda place, name: code_of(found.written((place, name))))
    write_pieces(file, pieces)
    put(open_console(), str(file))


@results.command("fill", epilog=FILL_EXAMPLES)
def fill_in(
    ctx: typer.Context,
    sheet: Annotated[Path, typer.Argument(metavar="SHEET", help="The sheet, as your LMS exported it.")],
    folder: Folder,
    column: Annotated[
        str, typer.Option("--column", metavar="NAME", help="Which assignment: its name, or its id.")
    ] = "",
    exercise: Annotated[
        str,
        typer.Option("--exercise", metavar="ID", help="This exercise's points; by default, the total."),
    ] = "",
    scale: Annotated[
        bool | None, typer.Option("--scale/--no-scale", help="Whether to convert to the LMS's maximum.")
    ] = None,
    out: Annotated[
        Path | None, typer.Option("--out", metavar="FILE", help="By default, filled-SHEET in DIR.")
    ] = None,
) -> None:
    """Fill in the sheet that your LMS exported.

    The sheet is Canvas's gradebook, Moodle's grading worksheet, or Blackboard's
    columns. You can import the filled sheet there. People are matched by the
    LMS's own ids. No other cell is changed, and SHEET itself stays as it is.
    """
    with storing(f"{sheet} cannot be read"):
        content = sheet.read_bytes()
    page = _class(ctx, folder).page
    scores, most = _scores(page, exercise)
    found = fill(content, scores, most, id_of, column, scale)
    file = out or folder / f"filled-{sheet.name}"
    write_pieces(file, [found.content])
    _say(file, found, {one.person.id: one.person.name for one in page.sheets})


@results.command("moodle", epilog=MOODLE_EXAMPLES)
def moodle(ctx: typer.Context, folder: Folder) -> None:
    """Make a zip of the letters for Moodle.

    Upload it to the assignment with "Upload multiple feedback files in a zip".
    It contains the current letters, with your own marks.
    """
    file = folder / "moodle-feedback.zip"
    letters = _letters(ctx, folder, Lms.MOODLE)
    write_pieces(file, [moodle_feedback(letters)])
    put(open_console(), f"{file}: {len(letters)} letters.")


@results.command("canvas", epilog=CANVAS_EXAMPLES)
def canvas(ctx: typer.Context, folder: Folder) -> None:
    """Make a file of the letters for Canvas.

    Each letter becomes a comment. The command sends nothing; it shows the line
    that does. Canvas adds a new comment each time you send it.
    """
    file = folder / "canvas-comments.json"
    letters = _letters(ctx, folder, Lms.CANVAS)
    write_pieces(file, [canvas_comments(letters)])
    put(open_console(), f"{file}: {len(letters)} comments. To send them:")
    put(open_console(), _SEND.format(file))


def _letters(ctx: typer.Context, folder: Path, lms: Lms) -> list[tuple[str, str, str]]:
    """Each person's number in the LMS, name, and letter. Raises UsageError if nobody has a number."""
    with Results.look(folder.absolute()) as stored:
        page = read_class(folder.absolute(), stored, course_of(options_of(ctx))).page
        numbers = _numbers(people_of(stored), {one.person: one.source for one in stored.submissions()}, lms)
    if not any(numbers):
        step = f"Grade what {lms.value} exports with all submissions."
        raise UsageError(f"None of these submissions has a {lms.value} number in its name.", step)
    for sheet, number in zip(page.sheets, numbers, strict=True):
        if not number:
            what = (
                f"{sheet.person.id} {sheet.person.name}: left out, because the {lms.value} id is not known."
            )
            put_prose(open_console(), sanitize.paragraph(what))
    return [
        (number, sheet.person.name, letter(sheet, page.course))
        for sheet, number in zip(page.sheets, numbers, strict=True)
        if number
    ]


def _numbers(people: Sequence[Person], sources: Mapping[str, str], lms: Lms) -> list[str]:
    """The LMS's numbers in the class's order. Without a submission, the id, if ids are such numbers."""
    told = {one.id: lms_id(sources[one.id], lms) for one in people if not one.graded_as}
    found = {who: number for who, number in told.items() if number}
    ids_are_numbers = bool(found) and all(who == number for who, number in found.items())
    return [found.get(one.id, one.id if ids_are_numbers and one.id.isdecimal() else "") for one in people]


def _class(ctx: typer.Context, folder: Path) -> ReadClass:
    with Results.look(folder.absolute()) as stored:
        return read_class(folder.absolute(), stored, course_of(options_of(ctx)))


def _scores(page: ClassPage, exercise: str) -> tuple[dict[str, Score], float]:
    """The scores by id, and the highest possible one."""
    asked = [one for one in page.exercises if exercise in ("", one.id)]
    if not asked:
        there = ", ".join(one.id for one in page.exercises)
        raise UsageError(f"{exercise} was not graded here.", f"Name one of these: {there}")
    most = sum(one.max_points for one in asked if exercise or not one.bonus)
    return {sheet.person.id: _score(sheet, exercise) for sheet in page.sheets}, most


def _score(sheet: Sheet, exercise: str) -> Score:
    mark = next((one for one in sheet.marks if one.exercise.id == exercise), None)
    return Score(mark.points, mark.verdict) if mark else Score(sheet.points, sheet.state)


def _say(file: Path, found: Filled, names: dict[str, str]) -> None:
    console = open_console()
    put(console, str(file))
    changed = f", {found.changed} of them replacing another value" if found.changed else ""
    put(console, f"{found.lms}, {sanitize.one_line(found.column)}: {found.filled} filled in{changed}.")
    for who, why in found.left:
        put_prose(
            console, sanitize.paragraph(f"{who} {names.get(who, '')}".strip() + f": left as it was, {why}.")
        )
    for who in found.absent:
        put_prose(console, sanitize.paragraph(f"{who} {names.get(who, '')}".strip() + ": not in this sheet."))
