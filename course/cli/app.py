"""The command line as a whole: options for every command, and the list of commands."""

from __future__ import annotations

from functools import cached_property
from importlib import import_module
from pathlib import Path
from typing import Annotated, Any

import typer
from typer.core import TyperCommand, TyperGroup

from course import __version__
from course.cli.extras import extra
from course.cli.options import Options, course_named
from course.cli.usage import PROGRAM, examples

EPILOG = (
    examples(
        ("next", "begin, or continue where you left off"),
        ("check", "check your current exercise"),
        ("watch", "check it at every save"),
        ("hint", "a hint for it"),
        ("shell", "a shell in your course home, with ROS 2 ready"),
        ("doctor", "what this machine has, and what is missing"),
        ("COMMAND --help", "more about a command, with examples"),
    )
    + "\n\n\b\nExit codes: 0 passed or done, 1 not passed, 2 wrong usage,"
    + "\n3 an error of ours, 4 something is missing here, 130 stopped with Ctrl+C."
)


class LazyCommand(TyperCommand):
    """A command whose module is imported only when the command is typed, not when it is listed.

    module: its name in `course.cli`, or the name of an optional tool. function: its name in the module, or
    that of a Typer with subcommands.
    """

    def __init__(self, name: str, help: str, module: str, function: str, epilog: str = "EXAMPLES") -> None:
        super().__init__(name, help=help)
        self._place = module, function, epilog

    @cached_property
    def loaded(self) -> Any:
        """The command itself, or the group of its subcommands."""
        name, function, epilog = self._place
        module = extra(name) if name in OPTIONAL else import_module(f"course.cli.{name}")
        found = getattr(module, function)
        if not isinstance(found, typer.Typer):
            single = typer.Typer(rich_markup_mode=None, add_completion=False)
            single.command(self.name)(found)
            found = single
        command = typer.main.get_command(found)
        command.epilog = getattr(module, epilog)
        return command

    def make_context(self, info_name: str | None, args: list[str], parent: Any = None, **more: Any) -> Any:
        return self.loaded.make_context(info_name, args, parent=parent, **more)


# Optional tools with a command of their own.
OPTIONAL = ("similar",)
# In the order of the list. It describes each with the first sentence of the command's own help.
COMMANDS = (
    LazyCommand("next", "Show the next exercise and put its files in place.", "next_", "next_"),
    LazyCommand("check", "Build and run what you wrote, and judge what it does.", "check", "check"),
    LazyCommand("watch", "Check at every save, and show the results.", "watch", "watch"),
    LazyCommand("hint", "Show the next hint for an exercise.", "hint", "hint"),
    LazyCommand("review", "Answer a few questions from earlier quizzes again.", "review", "review"),
    LazyCommand("play", "Start the nodes of a mystery, for you to explore.", "play", "play"),
    LazyCommand("list", "List the exercises and your progress in each.", "listing", "list_"),
    LazyCommand("show", "Show the text of an exercise. Changes nothing.", "show", "show"),
    LazyCommand("reset", "Put an exercise's files back as they were at the start.", "reset", "reset"),
    LazyCommand("solution", "Show how a solution differs from your files.", "solution", "solution"),
    LazyCommand("init", "Create a course home, the folder that you work in.", "init", "init"),
    LazyCommand("shell", "Open bash in your course home, with ROS 2 ready.", "shell", "shell"),
    LazyCommand(
        "env", "Print the lines that set up your own shell for the course.", "shell", "env", "ENV_EXAMPLES"
    ),
    LazyCommand("pack", "Make a zip to hand in.", "pack", "pack"),
    LazyCommand("grade", "Grade a class of submissions.", "grade", "grade"),
    LazyCommand("regrade", "Judge a graded class again.", "regrade", "regrade"),
    LazyCommand("results", "Mark a class by hand, or fill in your LMS.", "results", "results"),
    LazyCommand("report", "Make a report page for a graded class.", "report", "report"),
    LazyCommand("serve", "Show a class while it is being graded.", "serve", "serve"),
    LazyCommand("bundle", "Make an autograder for Gradescope.", "bundle", "make_bundle"),
    LazyCommand("similar", "Show submissions with similar code.", "similar", "similar"),
    LazyCommand("new", "Create a course, a chapter, or an exercise to start from.", "new", "new"),
    LazyCommand("api", "Show what a grader can call, and what it gets back.", "api", "api"),
    LazyCommand("schema", "Show the JSON Schema of lesson.yaml and similar files.", "schema", "schema"),
    LazyCommand("validate", "Prove that a course does what it claims.", "validate", "validate"),
    LazyCommand("doctor", "Check this machine: ROS 2, compilers, disk, clock.", "doctor", "doctor"),
    LazyCommand(
        "build-underlay", "Build the ROS packages that come with the course.", "underlay", "build_underlay"
    ),
    LazyCommand("evidence", "Show what `check` recorded, or export it.", "evidence", "evidence"),
)


class Commands(TyperGroup):
    def __init__(self, **attrs: Any) -> None:
        super().__init__(**{**attrs, "commands": COMMANDS})


app = typer.Typer(
    name=PROGRAM,
    cls=Commands,
    # Plain help: quick to show, and the same with and without color.
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
    """An interactive ROS 2 course: read a lesson, write a node, have it checked.

    Your work is in a course home: the folder that you give with --home, or else
    the one in the environment variable ROS2COURSE_HOME, the one you are in, or
    ~/ros2course. `next` creates it if there is none. A course home that was
    created with --course remembers its course.
    """
    ctx.obj = Options(home=home, course=course_named(course), fork_server=ctx.obj)
    if ctx.invoked_subcommand is None:
        typer.echo(ctx.get_help())
