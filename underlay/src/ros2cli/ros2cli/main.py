"""The `ros2` command: parse, call, and turn what came of it into an exit code."""

# PYTHON_ARGCOMPLETE_OK
from __future__ import annotations

import atexit
import contextlib
import os
import sys
from argparse import Namespace
from collections.abc import Sequence

from ros2cli.errors import TERMINATED, CommandError
from ros2cli.parser import ros2_parser

INTERRUPTED = 2
CLOSED_PIPE = 141  # as the shell tells it: 128 + SIGPIPE


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command line; the exit code."""
    try:
        code = _guarded(argv)
        sys.stdout.flush()
    except BrokenPipeError:
        code = CLOSED_PIPE
        _forget_output()
    except KeyboardInterrupt:
        code = INTERRUPTED
    return code if argv is not None else _leave(code)


def _guarded(argv: Sequence[str] | None) -> int:
    try:
        return _exit_code(_run(argv))
    except CommandError as error:
        return _refuse(str(error), error.code)
    except (KeyboardInterrupt, BrokenPipeError):
        raise
    except Exception as error:  # noqa: BLE001  the last line of defense: no traceback for a learner
        return _unexpected(error)


def _run(argv: Sequence[str] | None) -> int | str | None:
    parser = ros2_parser()
    if "_ARGCOMPLETE" in os.environ:
        from ros2cli.completion import complete

        complete(parser)
    args = parser.parse_args(argv)
    _buffer_lines(args)
    result: int | str | None = args.main(args)
    return result


def _buffer_lines(args: Namespace) -> None:
    if not args.use_python_default_buffering and hasattr(sys.stdout, "reconfigure"):
        sys.stdout.reconfigure(line_buffering=True)


def _exit_code(result: int | str | None) -> int:
    return _refuse(result, 1) if isinstance(result, str) else int(result or 0)


def _refuse(message: str, code: int) -> int:
    sys.stdout.flush()
    if message:
        print(message, file=sys.stderr)
    return code


def _unexpected(error: Exception) -> int:
    """One line for what no command foresaw; the whole story where it is asked for."""
    if type(error).__name__ == "ExternalShutdownException":  # rclpy's, when SIGTERM came
        return TERMINATED
    if "ROS2CLI_TRACEBACK" in os.environ:
        raise error
    return _refuse(str(error) if isinstance(error, RuntimeError) else f"{type(error).__name__}: {error}", 1)


def _leave(code: int) -> int:
    """The middleware takes a tenth of a second to unload, which nobody needs once the node is gone."""
    if "rclpy._rclpy_pybind11" not in sys.modules:
        return code
    atexit._run_exitfuncs()
    for stream in (sys.stdout, sys.stderr):
        with contextlib.suppress(OSError, ValueError):
            stream.flush()
    os._exit(code)


def _forget_output() -> None:
    """Keep Python from complaining about the closed pipe when it flushes at the end."""
    with contextlib.suppress(OSError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
