"""The entry point, and the one place where errors become a message and an exit code."""

from __future__ import annotations

import gc
import io
import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import closing, contextmanager
from typing import TYPE_CHECKING, NoReturn

from course.cli.usage import PROGRAM, global_options_first
from course.errors import ContentError, CourseError, ExitCode

if TYPE_CHECKING:
    from course.grading.supervisor import ForkServer

DEBUG = "ROS2COURSE_DEBUG"


def run() -> NoReturn:
    """What the console script calls: runs the command line and ends the process."""
    gc.set_threshold(10_000)  # `hint` makes little garbage: looking for it took a sixth of its time
    code = main(sys.argv[1:])
    gc.freeze()  # nor does Python look for it at the end
    sys.exit(code)


def main(words: Sequence[str]) -> int:
    """Run one command line and return its exit code. No Exception passes through."""
    _write_any_character()
    try:
        code = _dispatch(words)
        sys.stdout.flush()
        return code
    except KeyboardInterrupt:
        return ExitCode.INTERRUPTED
    except BrokenPipeError:
        return _reader_went_away()
    except CourseError as error:
        return _report(error)
    except Exception as error:  # noqa: BLE001  # the boundary: a bug ends in a log, not in a learner's face
        return _report_bug(error, words)


def _dispatch(words: Sequence[str]) -> int:
    with _loading_early(words) as fork_server:
        from typer.main import get_command

        from course.cli.app import app

        try:
            get_command(app).main(args=global_options_first(words), prog_name=PROGRAM, obj=fork_server)
        except SystemExit as exit_:
            return _code(exit_)
    return ExitCode.PASSED


@contextmanager
def _loading_early(words: Sequence[str]) -> Iterator[ForkServer | None]:
    """Start early the process that `check` forks from, because `check` has to wait until it has loaded."""
    if "check" not in words or "--help" in words or "-h" in words:
        yield None
        return
    from course.grading.supervisor import ForkServer

    with closing(ForkServer()) as fork_server:
        fork_server.start_early()
        yield fork_server


def _code(exit_: SystemExit) -> int:
    if exit_.code is None or isinstance(exit_.code, int):
        return exit_.code or ExitCode.PASSED
    print(exit_.code, file=sys.stderr)
    return ExitCode.NOT_PASSED


def _write_any_character() -> None:
    # A quote in Greek must not end a check on a terminal that only knows Latin-1.
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")


def _reader_went_away() -> int:
    # `ros2course list | head`: Python would complain when it flushes the rest at its end.
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return ExitCode.NOT_PASSED


def _report(error: CourseError) -> int:
    from course.cli.usage import spoken
    from course.report.console import error_console
    from course.report.problem import render_problem

    place = _place(error) if isinstance(error, ContentError) else ""
    render_problem(error_console(), place + error.what, spoken(error.next_step or ""))
    if os.environ.get(DEBUG):
        _print_traceback(error)
    return error.exit_code


def _place(error: ContentError) -> str:
    line = f":{error.line}" if error.line else ""
    key = f" ({error.key})" if error.key else ""
    return f"{error.file}{line}{key}: "


def _report_bug(error: Exception, words: Sequence[str]) -> int:
    from course.cli.log import write_log
    from course.report.console import error_console
    from course.report.problem import render_bug

    log = write_log("error", error, words)
    render_bug(error_console(), f"{type(error).__name__}: {error}", log)
    if log is None or os.environ.get(DEBUG):
        _print_traceback(error)
    return ExitCode.OUR_FAULT


def _print_traceback(error: Exception) -> None:
    import traceback

    traceback.print_exception(error, file=sys.stderr)
