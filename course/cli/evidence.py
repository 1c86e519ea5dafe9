"""`evidence`: what `check` recorded, to look at or to export."""

from __future__ import annotations

from contextlib import nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from course.cli.session import CourseSession, CurrentExercise, Pager, complete_exercise, open_session
from course.cli.usage import examples, typed
from course.errors import StorageError, UsageError
from course.evidence.mcap_file import BadRecording, OtherFormat, load
from course.evidence.recording import Recording
from course.grading.load import runs_programs
from course.home import CourseHome
from course.home.storage import copy_new, copy_over, storing
from course.report.activity import activity
from course.report.console import error_console, open_console, paged
from course.report.pictures.recording_text import belongs, is_secret, render_exported, render_recording

if TYPE_CHECKING:
    from course.model.result import Result


@dataclass(frozen=True)
class Recorded:
    """A recording, and the file that it was read from. size: of the file, in bytes."""

    recording: Recording
    file: Path
    size: int


def recording_file(home: CourseHome, exercise: str) -> Path:
    """The path of this exercise's last recording, whether or not it exists."""
    return home.state / "evidence" / f"{exercise}.mcap"


def recorded(home: CourseHome, exercise: str) -> Recorded | None:
    """The last recording of this exercise; None when there is none. Raises as `read_recording` does."""
    file = recording_file(home, exercise)
    return read_recording(file, f"`{typed(f'check {exercise}')}` records it.") if file.is_file() else None


def read_recording(file: Path, otherwise: str) -> Recorded:
    """Raises UsageError, with `otherwise` as the next step, if it is damaged or not a recording."""
    try:
        with activity(error_console(), "reading the recording", quiet=True):
            return Recorded(load(file), file, file.stat().st_size)
    except OtherFormat:
        raise UsageError(f"{file} was recorded by another version of ros2course.", otherwise) from None
    except BadRecording:
        raise UsageError(f"{file} is damaged, or is not a recording of the course.", otherwise) from None


SHOW_EXAMPLES = examples(
    ("evidence show", "of your current exercise"),
    ("evidence show 18-publisher", "of another one"),
    ("evidence show quotes.mcap", "of any recording of the course"),
)
EXPORT_EXAMPLES = examples(
    ("evidence export --to quotes.mcap", "of your current exercise"),
    ("evidence export 18-publisher --to ~/bags/", "of another one, into a folder"),
)
EXAMPLES = examples(
    ("evidence show", "draw what the last check saw"),
    ("evidence export --to quotes.mcap", "to open it elsewhere"),
)
_FILE = ".mcap"

evidence = typer.Typer(rich_markup_mode=None)


@evidence.callback()
def about() -> None:
    """Show what `check` recorded, or export it."""


@evidence.command(epilog=SHOW_EXAMPLES)
def show(
    ctx: typer.Context,
    what: Annotated[
        str | None,
        typer.Argument(
            metavar="[ID|FILE]",
            help="The exercise, or a recording: a file whose name ends in .mcap. "
            "Without it, your current exercise.",
            autocompletion=complete_exercise,
            show_default=False,
        ),
    ] = None,
    pager: Pager = False,
) -> None:
    """Draw what happened in an exercise's last check.

    Draws programs, nodes, messages, calls, and logs on one timeline, next to
    what was expected. Also draws the numbers in messages, the time between
    messages, and who publishes and who listens.
    """
    found, result = _of_file(Path(what)) if what and what.endswith(_FILE) else _of_exercise(ctx, what)
    console = open_console()
    with paged(console) if pager else nullcontext():
        render_recording(console, found.recording, found.size, result)


@evidence.command(epilog=EXPORT_EXAMPLES)
def export(
    ctx: typer.Context,
    to: Annotated[Path, typer.Option("--to", metavar="FILE", help="The new file, or a folder for it.")],
    exercise: CurrentExercise = None,
    force: Annotated[bool, typer.Option("--force", help="Replace the file if it exists.")] = False,
) -> None:
    """Copy the last check's recording to where you want it.

    It is an MCAP file, which Foxglove and PlotJuggler open. An existing file is
    kept unless you add --force.
    """
    found, _ = _of_exercise(ctx, exercise)
    name = found.recording.exercise
    if is_secret(found.recording):
        what = f"{name} is a mystery: its recording contains what you should find out."
        raise UsageError(what, f"`{typed(f'play {name}')}` runs its nodes for you to explore.")
    target = to / found.file.name if to.is_dir() else to
    _copy(found.file, target, force=force)
    render_exported(open_console(), name, target, found.size)


def _of_exercise(ctx: typer.Context, name: str | None) -> tuple[Recorded, Result | None]:
    with open_session(ctx) as session:
        found = _recorded(session, name)
        last = session.progress.last_result(found.recording.exercise)
    return found, last if belongs(last, found.recording) else None


def _recorded(session: CourseSession, name: str | None) -> Recorded:
    chosen = session.exercise(name)
    found = recorded(session.home, chosen.id)
    if found is None:
        if not runs_programs(chosen):
            raise UsageError(f"{chosen.id} has questions only: nothing is run, so nothing is recorded.")
        raise UsageError(
            f"There is no recording of {chosen.id} yet.", f"`{typed(f'check {chosen.id}')}` makes one."
        )
    return found


def _of_file(file: Path) -> tuple[Recorded, None]:
    if not file.is_file():
        raise UsageError(f"There is no file {file}.", f"`{typed('evidence show')}` shows the last recording.")
    return read_recording(file, f"`{typed('evidence show')}` shows the last recording."), None


def _copy(source: Path, target: Path, *, force: bool) -> None:
    if target.resolve() == source.resolve():
        raise UsageError(f"{target} is the recording itself.", "Name another file.")
    if not target.parent.is_dir():
        raise StorageError(f"There is no folder {target.parent}.", "Create it first, or name another one.")
    with storing(f"{target} cannot be written"):
        if force:
            copy_over(source, target)
        elif not copy_new(source, target):
            raise UsageError(f"{target} already exists.", "Name another file, or add --force to replace it.")
