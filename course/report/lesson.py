"""What a learner reads before and while working: the chapter's text, the exercise, its hints."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Protocol

from rich.console import Console
from rich.text import Text

from course.report import safe
from course.report.console import put, put_prose
from course.report.markdown import put_markdown


class ChapterName(Protocol):
    @property
    def number(self) -> int: ...

    @property
    def title(self) -> str: ...


class ExerciseText(Protocol):
    """What is shown of an exercise."""

    @property
    def id(self) -> str: ...

    @property
    def title(self) -> str: ...

    @property
    def text(self) -> str: ...

    @property
    def chapter(self) -> ChapterName: ...

    @property
    def files(self) -> tuple[str, ...]: ...


def render_lesson(console: Console, chapter: ChapterName, text: str) -> None:
    """A chapter's text under its title."""
    put(console, _rule(console, f"Chapter {chapter.number}: {chapter.title}"))
    put(console)
    put_markdown(console, _without_title(text, chapter.title))
    put(console)


def render_exercise(console: Console, exercise: ExerciseText, home: Path, state: str = "") -> None:
    """An exercise's task under its title, and the learner's files that belong to it."""
    put(console, _rule(console, f"{exercise.id}: {exercise.title}", state))
    put(console)
    put_markdown(console, _without_title(exercise.text, exercise.title))
    if exercise.files:
        put(console)
        put(console, f"Your files, in {safe.one_line(str(home))}:", "bold")
        for file in exercise.files:
            put(console, f"  {safe.one_line(file)}")
    put(console)


def render_new_files(console: Console, home: Path, files: Sequence[Path]) -> None:
    """Which files were laid into the course home just now, after `render_exercise`; nothing for none."""
    if not files:
        return
    put(console, "New files, laid just now:", "bold")
    for file in files:
        put(console, f"  + {safe.one_line(_relative(file, home))}")
    put(console)


def render_new_home(console: Console, home: Path, *, was_there: bool, course: Path | None = None) -> None:
    """That a course home was made, and what it is for; or that it was there already.

    course: what it belongs to from now on, if that is to be said.
    """
    if was_there:
        put(console, f"This is a course home already: {safe.one_line(str(home))}")
    else:
        put(console, Text.assemble(("Made a course home: ", "bold"), safe.one_line(str(home))))
        put_prose(
            console, "It is the folder you will work in. Where a lesson writes ~, it means this folder."
        )
    if course is not None:
        put(console, f"It is for the course {safe.one_line(str(course.absolute()))}")
    put(console)


def put_requires(console: Console, needed: Sequence[str]) -> None:
    """Which exercises come before this one and are not passed yet; nothing when there are none."""
    if needed:
        put_prose(console, f"It stands on what you make in {', '.join(needed)}, which is not passed yet.")
        put(console)


def render_hint(console: Console, exercise_id: str, number: int, total: int, text: str) -> None:
    """One hint: `number` counts from 1."""
    put(console, Text(f"Hint {number} of {total} for {exercise_id}", "bold"))
    put(console)
    put_markdown(console, text)
    put(console)


def render_after(console: Console, text: str) -> None:
    """What a lesson says after a pass."""
    put(console)
    put_markdown(console, text)


class Reset(Protocol):
    """What `reset` did; see `course.home.ResetReport`."""

    @property
    def backup(self) -> Path | None: ...

    @property
    def saved(self) -> tuple[str, ...]: ...

    @property
    def restored(self) -> tuple[str, ...]: ...

    @property
    def removed(self) -> tuple[str, ...]: ...

    @property
    def kept(self) -> tuple[str, ...]: ...


def render_reset(console: Console, report: Reset) -> None:
    """Where the backup is, and which files are new, gone or left as they were."""
    if report.backup is None:
        put(console, "There were no files of yours to save.")
    else:
        put(console, Text.assemble(("Your files are saved in ", "bold"), safe.one_line(str(report.backup))))
        _put_files(console, " ", report.saved)
    _put_files(console, "+", report.restored, "Laid anew:")
    _put_files(console, "-", report.removed, "Removed (they are in the backup):")
    _put_files(console, "=", report.kept, "Left as they are, since other exercises use them too:")
    put(console)


def _put_files(console: Console, mark: str, files: Sequence[str], title: str = "") -> None:
    if files and title:
        put(console, title)
    for file in files:
        put(console, f"  {mark} {safe.one_line(file)}")


def _rule(console: Console, title: str, remark: str = "") -> Text:
    remark = f" ({remark})" if remark else ""
    shown = f"== {safe.paragraph(title)}{remark} "
    return Text(shown + "=" * max(console.width - len(shown), 2), "bold")


def _without_title(text: str, title: str) -> str:
    """The text without a first heading that only repeats the title above it."""
    first, _, rest = text.lstrip().partition("\n")
    repeats = first.startswith("# ") and title.casefold() in first.casefold()
    return rest.lstrip("\n") if repeats else text


def _relative(file: Path, home: Path) -> str:
    return str(file.relative_to(home)) if file.is_relative_to(home) else str(file)
