"""`new`: a course, a chapter or an exercise to start from."""

from __future__ import annotations

import shlex
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from course.authoring.course_folder import is_course, new_chapter, new_course
from course.authoring.exercise import ExerciseKind, new_exercise
from course.cli.options import Options, options_of
from course.cli.usage import examples, typed
from course.errors import UsageError
from course.report.console import open_console, put_steps
from course.report.exercise_text import render_made

if TYPE_CHECKING:
    from course.authoring.write import Made

EXAMPLES = examples(
    ("new course robots", "a course"),
    ("--course robots new chapter 30-power", "a chapter in it"),
    ("--course robots new chapter power", "the next number"),
    ("--course robots new exercise power/battery", "an exercise"),
    ("--course robots new exercise power/a --kind quiz", "another kind"),
)

Steps = list[tuple[str, str]]


class What(str, Enum):
    """What can be made."""

    COURSE = "course"
    CHAPTER = "chapter"
    EXERCISE = "exercise"


def new(
    ctx: typer.Context,
    what: Annotated[What, typer.Argument(metavar="WHAT", help="course, chapter, or exercise.")],
    name: Annotated[str, typer.Argument(metavar="NAME", help="See the examples.")],
    kind: Annotated[
        ExerciseKind | None, typer.Option("--kind", help="What the exercise is about.", show_default="topic")
    ] = None,
) -> None:
    """Create a course, a chapter, or an exercise to start from.

    An exercise is complete: it has a starter, a solution, a grader and known
    mistakes, and passes `validate` as it is. Existing files are not overwritten.
    """
    if kind and what is not What.EXERCISE:
        raise UsageError("--kind is for an exercise.", "Leave it out.")
    made, steps = _MAKERS[what](options_of(ctx), name, kind or ExerciseKind.TOPIC)
    console = open_console()
    render_made(console, f"Created the {what.value} {made.name}", made.root, made.new, made.changed)
    put_steps(console, steps)


def _course(options: Options, name: str, _: ExerciseKind) -> tuple[Made, Steps]:
    root = Path(name).expanduser().absolute()
    return new_course(root), [(typed(f"new chapter 01-NAME {_of(root)}"), "for its first chapter")]


def _chapter(options: Options, name: str, _: ExerciseKind) -> tuple[Made, Steps]:
    root = _root(options)
    made = new_chapter(root, name)
    return made, [(typed(f"new exercise {made.name}/NAME {_of(root)}"), "for an exercise in it")]


def _exercise(options: Options, name: str, kind: ExerciseKind) -> tuple[Made, Steps]:
    root = _root(options)
    made = new_exercise(root, name, kind)
    return made, [
        (typed(f"validate {made.name} {_of(root)}"), "to prove it, now and whenever you change it"),
        (typed(f"next {made.name} {_of(root)}"), "to see it as learners do"),
    ]


def _root(options: Options) -> Path:
    """The given course, or the one in the current folder."""
    root = (options.course or Path()).absolute()
    if options.course is None and not is_course(root):
        raise UsageError("It is not clear which course this is for.", "Say which: `--course DIR`.")
    return root


def _of(root: Path) -> str:
    return f"--course {shlex.quote(str(root))}"


_MAKERS = {What.COURSE: _course, What.CHAPTER: _chapter, What.EXERCISE: _exercise}
