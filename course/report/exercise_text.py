"""What a learner reads in the terminal: lessons, exercises, questions, hints, and lists of these."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path
from string import ascii_lowercase
from typing import TYPE_CHECKING, Protocol

from rich.console import Console
from rich.text import Text

from course.report import sanitize
from course.report.console import number, put, put_prose, with_code

if TYPE_CHECKING:
    from course.content import ChapterRef, Exercise, Question


def _put_markdown(console: Console, text: str) -> None:
    from course.report.markdown import put_markdown  # slow to import, and `list` does not need it

    put_markdown(console, text)


def render_lesson(console: Console, chapter: ChapterRef, text: str) -> None:
    """A chapter's text under its title."""
    put(console, _rule(console, f"Chapter {chapter.number}: {chapter.title}"))
    put(console)
    _put_markdown(console, _without_title(text, chapter.title))
    put(console)


def render_exercise(console: Console, exercise: Exercise, home: Path, state: str = "") -> None:
    """An exercise's task under its title, and the learner's files that belong to it."""
    put(console, _rule(console, f"{exercise.id}: {exercise.title}", state))
    put(console)
    _put_markdown(console, _without_title(exercise.text, exercise.title))
    if exercise.files:
        put(console)
        put(console, f"Your files, in {sanitize.one_line(str(home))}:", "bold")
        for file in exercise.files:
            put(console, f"  {sanitize.one_line(file)}")
    put(console)


def render_new_files(console: Console, home: Path, files: Sequence[Path]) -> None:
    """The files that were just copied into the course home; call it after `render_exercise`."""
    if not files:
        return
    put(console, "New files, just added:", "bold")
    for file in files:
        put(console, f"  + {sanitize.one_line(_relative(file, home))}")
    put(console)


def render_new_home(console: Console, home: Path, *, was_there: bool, course: Path | None = None) -> None:
    """Say that a course home was made, and what it is for; or that it was there already.

    course: the course that it belongs to from now on, if that should be shown.
    """
    if was_there:
        put(console, f"This already is a course home: {sanitize.one_line(str(home))}")
    else:
        put(console, Text.assemble(("Created a course home: ", "bold"), sanitize.one_line(str(home))))
        put_prose(console, "It is the folder you will work in. When a lesson writes ~, it means this folder.")
    if course is not None:
        put(console, f"It is for the course {sanitize.one_line(str(course.absolute()))}")
    put(console)


def put_requires(console: Console, needed: Sequence[str]) -> None:
    """The exercises that this one builds on and that are not passed yet; nothing if there are none."""
    if needed:
        put_prose(console, f"It builds on {', '.join(needed)}, which you have not passed yet.")
        put(console)


def render_hint(console: Console, exercise_id: str, number: int, total: int, text: str) -> None:
    """One hint: `number` counts from 1."""
    put(console, Text(f"Hint {number} of {total} for {exercise_id}", "bold"))
    put(console)
    _put_markdown(console, text)
    put(console)


def render_after(console: Console, text: str) -> None:
    """The lesson's text that follows a pass."""
    put(console)
    _put_markdown(console, text)


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
    """Where the backup is, and which files were restored, removed or left as they were."""
    if report.backup is None:
        put(console, "You had no files to save.")
    else:
        put(
            console,
            Text.assemble(("Your files are saved in ", "bold"), sanitize.one_line(str(report.backup))),
        )
        _put_files(console, " ", report.saved)
    _put_files(console, "+", report.restored, "Restored:")
    _put_files(console, "-", report.removed, "Removed (they are in the backup):")
    _put_files(console, "=", report.kept, "Left as they are, because other exercises use them too:")
    put(console)


def _put_files(console: Console, mark: str, files: Sequence[str], title: str = "") -> None:
    if files and title:
        put(console, title)
    for file in files:
        put(console, f"  {mark} {sanitize.one_line(file)}")


def _rule(console: Console, title: str, remark: str = "") -> Text:
    remark = f" ({remark})" if remark else ""
    shown = f"== {sanitize.paragraph(title)}{remark} "
    return Text(shown + "=" * max(console.width - len(shown), 2), "bold")


def _without_title(text: str, title: str) -> str:
    """The text without its first heading, if that only repeats the title above it."""
    first, _, rest = text.lstrip().partition("\n")
    repeats = first.startswith("# ") and title.casefold() in first.casefold()
    return rest.lstrip("\n") if repeats else text


def _relative(file: Path, home: Path) -> str:
    return str(file.relative_to(home)) if file.is_relative_to(home) else str(file)


LETTERS = ascii_lowercase


def render_question(console: Console, question: Question, *, number: int, total: int) -> None:
    """The current question: `number` of `total`, from 1. Its choices get letters."""
    put(console)
    put(console, f"Question {number} of {total}", "bold")
    _put_markdown(console, question.ask)
    if question.choices:
        put(console)
    for letter, choice in zip(LETTERS, question.choices, strict=False):
        put_prose(console, with_code(console, choice.text), first=f"  {letter}  ")
    put(console)


def render_output(console: Console, predicted: str, lines: Sequence[str]) -> None:
    """What a program printed, below the choice that predicted it."""
    put(console)
    put_prose(console, with_code(console, predicted), first="  You said:    ")
    for row, line in enumerate(lines or ("nothing",)):
        put(console, f"  {'' if row else 'It printed:':11}  {sanitize.one_line(line)}")


def render_questions(console: Console, questions: Iterable[Question]) -> None:
    """All questions, under their names from the answers file."""
    put(console, "The questions:", "bold")
    for question in questions:
        put(console)
        put(console, Text(question.id, "bold"))
        _put_markdown(console, question.ask)
        for choice in question.choices:
            put_prose(console, with_code(console, choice.text), first="  - ")
    put(console)


STATE_MARKS = {
    "passed": ("ok", "green"),
    "tried": ("no", "red"),
    "begun": ("..", "yellow"),
    "new": ("  ", ""),
}
TO_READ = "only to read: it is shown along the way"
LEGEND = "ok passed   no not passed yet   .. started   > where you are"


@dataclass(frozen=True)
class ExerciseRow:
    """One exercise. `state` is new, begun, tried or passed; points are None before the first check."""

    chapter: str
    exercise: str
    title: str
    state: str
    current: bool = False
    best: float | None = None
    most: float | None = None


def render_list(console: Console, rows: Iterable[ExerciseRow], chapters: Iterable[str] = ()) -> None:
    """Chapters with their exercises, one line each, and the total at the end.

    chapters: all of them, in their order, even those without exercises; by default, those of the rows.
    """
    every = list(rows)
    width = max((len(row.exercise) for row in every), default=0)
    members = {name: list(those) for name, those in groupby(every, key=lambda row: row.chapter)}
    for chapter in tuple(chapters) or members:
        put(console, Text(sanitize.one_line(chapter), "bold"))
        for row in members.get(chapter, ()):
            put(console, _exercise_line(console, row, width))
        if chapter not in members:
            put(console, f"      {TO_READ}", "dim")
    passed = sum(row.state == "passed" for row in every)
    put(console)
    put(console, f"{passed} of {len(every)} passed.", "bold")
    put(console, LEGEND, "dim")


def _exercise_line(console: Console, row: ExerciseRow, width: int) -> Text:
    mark, style = STATE_MARKS[row.state]
    points = _points(row)
    here = ">" if row.current else " "
    room = max(console.width - width - len(points) - 11, 10)
    title = Text(sanitize.one_line(row.title))
    title.truncate(room, overflow="ellipsis", pad=True)
    name = f"  {row.exercise.ljust(width)}  "
    line = Text.assemble((f"{here} ", "bold"), (mark, style), name, title, f"  {points}")
    line.rstrip()
    return line


def _points(row: ExerciseRow) -> str:
    if row.best is None:
        return ""
    most = f" of {number(row.most)}" if row.most is not None else ""
    return f"{number(row.best)}{most}"


DIFF_STYLES = {"+": "green", "-": "red", "@": "cyan"}
LONGEST_LINE = 2000


def render_diff(console: Console, files: Iterable[tuple[str, str]]) -> bool:
    """Print unified diffs (file, text) and which files are the same. Return whether anything differs."""
    differs = False
    for file, diff in files:
        if not diff.strip():
            put(console, Text(f"{sanitize.one_line(file)}: the same as the reference", "dim"))
            continue
        differs = True
        for line in diff.rstrip("\n").split("\n"):
            put(console, _diff_line(line))
        put(console)
    return differs


def _diff_line(line: str) -> Text:
    style = "bold" if line.startswith(("---", "+++")) else DIFF_STYLES.get(line[:1], "")
    return Text(sanitize.one_line(line, LONGEST_LINE), style)


def render_made(
    console: Console, what: str, root: Path, new: Iterable[Path], changed: Iterable[Path]
) -> None:
    """The new files (`+`) and the changed ones (`~`), relative to the course."""
    put(console, f"{what} in {sanitize.one_line(str(root))}:", "bold")
    for mark, files in (("+", new), ("~", changed)):
        for file in sorted(files):
            put(console, f"  {mark} {sanitize.one_line(str(file.relative_to(root)))}")
    put(console)
