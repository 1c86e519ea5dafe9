"""`ros2 run`: one executable of a package, as a child that does not outlive the command."""

from __future__ import annotations

import argparse

from ros2cli.errors import CommandError
from ros2cli.verbs.pkg.installed import executable_names, executables, packages

NOT_FOUND = "No executable found"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take the package, the executable, and everything that is meant for it."""
    parser.add_argument(
        "--prefix",
        help="Prefix command, which should go before the executable. "
        "Command must be wrapped in quotes if it contains spaces (e.g. --prefix 'gdb -ex run --args').",
    )
    package = parser.add_argument("package_name", help="Name of the ROS package")
    package.completer = packages  # type: ignore[attr-defined]  # argcomplete's way
    executable = parser.add_argument("executable_name", help="Name of the executable")
    executable.completer = executable_names  # type: ignore[attr-defined]
    argv = parser.add_argument(
        "argv", nargs=argparse.REMAINDER, help="Pass arbitrary arguments to the executable"
    )
    argv.required = True  # as older Pythons have it: it is named when the executable is missing


def main(args: argparse.Namespace) -> int:
    """Run it, to its end; its exit code."""
    from ros2cli.commands.running.command_line import command_line
    from ros2cli.commands.running.supervised import run_supervised

    return run_supervised(command_line(_found(args), args.argv, args.prefix))


def _found(args: argparse.Namespace) -> str:
    """Return the executable's path. The same name in several folders is left for the user to sort out."""
    found = [path for path in executables(args.package_name) if path.name == args.executable_name]
    if not found:
        raise CommandError(NOT_FOUND)
    if len(found) > 1:
        paths = "".join(f"\n- {path}" for path in found)
        raise CommandError(f"Multiple executables found:{paths}")
    return str(found[0])
