"""`bundle`: the zip that an instructor uploads to Gradescope."""

from __future__ import annotations

import contextlib
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Annotated

import typer

import course
from course.batch.batch_plan import exercises_named
from course.cli.options import options_of
from course.cli.session import course_of
from course.cli.usage import examples
from course.errors import MissingHere, UsageError
from course.files import write_pieces
from course.report.activity import activity
from course.report.console import error_console
from course.report.gradebook.gradescope import bundle, zipped

EXAMPLES = examples(
    ("bundle --exercises 18,19", "autograder.zip, for two chapters"),
    ("bundle --out week3.zip", "all exercises, under another name"),
)
_TIME = 300
_CHECKOUT = Path(course.__file__).parents[1]


def make_bundle(
    ctx: typer.Context,
    exercises: Annotated[
        str,
        typer.Option(
            "--exercises", metavar="ID,...", help="What to grade; by default, everything that is handed in."
        ),
    ] = "",
    out: Annotated[Path, typer.Option("--out", metavar="FILE", help="The zip.")] = Path("autograder.zip"),
    wheel: Annotated[
        Path | None,
        typer.Option("--wheel", metavar="FILE", help="A wheel of ros2course; by default, one is built."),
    ] = None,
    no_sandbox: Annotated[
        bool, typer.Option("--no-sandbox", help="Grade there even if submissions cannot be contained.")
    ] = False,
) -> None:
    """Make an autograder for Gradescope.

    Upload the zip as the assignment's autograder. It sets itself up on Ubuntu
    22.04 or newer and grades each submission as `grade` does.
    """
    options = options_of(ctx)
    wanted = [name.strip() for name in exercises.split(",") if name.strip()]
    exercises_named(course_of(options), wanted)  # report unknown names here, not in Gradescope
    with activity(error_console(), "building the wheel", quiet=wheel is not None), _made(wheel) as made:
        packed = bundle(
            made.name, made.read_bytes(), wanted, _files_of(options.course), contained=not no_sandbox
        )
    write_pieces(out.absolute(), [zipped(packed)])
    print(f"{out} is ready: {out.stat().st_size / 1e6:.1f} MB.")


@contextlib.contextmanager
def _made(given: Path | None) -> Iterator[Path]:
    """The given wheel, or a temporary one."""
    if given is not None and not given.is_file():
        raise UsageError(f"There is no {given}.", "Name a wheel, or leave --wheel out.")
    with tempfile.TemporaryDirectory(prefix="ros2course-wheel-") as folder:
        yield given or _make(Path(folder))


def _make(folder: Path) -> Path:
    if not (_CHECKOUT / "pyproject.toml").is_file():
        what = "A wheel of the course can only be built from a clone of its repository."
        raise UsageError(what, "Make the bundle there, or give a wheel with --wheel.")
    pip = (sys.executable, "-m", "pip", "wheel", "--no-deps", "--quiet")
    command = [*pip, "-w", str(folder), str(_CHECKOUT)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=_TIME, check=False)
    found = sorted(folder.glob("*.whl"))
    if done.returncode != 0 or not found:
        last = (done.stderr.strip().splitlines() or ["pip said nothing"])[-1]
        raise MissingHere(f"The wheel was not built: {last}", "Try `pip wheel --no-deps .` in the clone.")
    return found[0]


def _files_of(root: Path | None) -> Mapping[str, bytes]:
    if root is None:
        return {}
    files = (file for file in sorted(root.rglob("*")) if file.is_file() and "__pycache__" not in file.parts)
    return {str(file.relative_to(root)): file.read_bytes() for file in files}
