"""`ros2 launch`: run a launch file, or tell what is in it."""

from __future__ import annotations

import argparse
import os
import re
import signal
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ros2cli.errors import CommandError

if TYPE_CHECKING:
    from launch import LaunchDescription, LaunchService
    from launch.actions import DeclareLaunchArgument

_FILE_NAME = re.compile(r".*launch\.(py|xml|yaml|yml)$")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "-n", "--noninteractive", default=not sys.stdin.isatty(), action="store_true",
        help="Run the launch system non-interactively, with no terminal associated",
    )  # fmt: skip
    parser.add_argument(
        "-d", "--debug", action="store_true",
        help="Put the launch system in debug mode, provides more verbose output.",
    )  # fmt: skip
    either = parser.add_mutually_exclusive_group()
    either.add_argument(
        "-p", "--print", "--print-description", action="store_true",
        help="Print the launch description to the console without launching it.",
    )  # fmt: skip
    either.add_argument(
        "-s", "--show-args", "--show-arguments", action="store_true",
        help="Show arguments that may be given to the launch file.",
    )  # fmt: skip
    parser.add_argument(
        "-a", "--show-all-subprocesses-output", action="store_true",
        help="Show all launched subprocesses' output by overriding their output configuration using the "
        "OVERRIDE_LAUNCH_PROCESS_OUTPUT envvar.",
    )  # fmt: skip
    parser.add_argument(
        "--launch-prefix",
        help="Prefix command, which should go before all executables. Command must be wrapped in quotes if "
        "it contains spaces (e.g. --launch-prefix 'xterm -e gdb -ex run --args').",
    )  # fmt: skip
    parser.add_argument(
        "--launch-prefix-filter",
        help="Regex pattern for filtering which executables the --launch-prefix is applied to by matching "
        "the executable name.",
    )  # fmt: skip
    _add_positionals(parser)


def _add_positionals(parser: argparse.ArgumentParser) -> None:
    package: Any = parser.add_argument(
        "package_name", help="Name of the ROS package which contains the launch file"
    )
    package.completer = _packages
    file: Any = parser.add_argument("launch_file_name", nargs="?", help="Name of the launch file")
    file.completer = _launch_files
    arguments: Any = parser.add_argument(
        "launch_arguments", nargs="*",
        help="Arguments to the launch file; '<name>:=<value>' (for duplicates, last one wins)",
    )  # fmt: skip
    arguments.completer = _arguments


def main(args: argparse.Namespace) -> int | str | None:
    path, words = _file_and_words(args)
    given = [_pair(word) for word in words]
    if args.show_all_subprocesses_output:
        os.environ["OVERRIDE_LAUNCH_PROCESS_OUTPUT"] = "both"
    if args.print:
        return _print_description(path)
    if args.show_args:
        return _print_arguments(path)
    given += [(name, getattr(args, key)) for name, key in _PREFIXES if getattr(args, key)]
    return _launch(path, given, args)


_PREFIXES = (("launch-prefix", "launch_prefix"), ("launch-prefix-filter", "launch_prefix_filter"))


# -- which file --------------------------------------------------------------------------------------------


def _file_and_words(args: argparse.Namespace) -> tuple[str, list[str]]:
    """A path stands alone, then what follows is arguments; otherwise a package and a file's name."""
    if Path(args.package_name).is_file():
        first = [] if args.launch_file_name is None else [args.launch_file_name]
        return args.package_name, [*first, *args.launch_arguments]
    return _in_package(args.package_name, args.launch_file_name), args.launch_arguments


def _in_package(package: str, name: str | None) -> str:
    from ament_index_python.packages import PackageNotFoundError, get_package_share_directory

    try:
        share = get_package_share_directory(package, print_warning=False)
    except (PackageNotFoundError, ValueError) as error:
        raise CommandError(f"Package '{package}' not found: {error}") from error
    found = [path for path in _files_below(share) if path.name == str(name)]
    if not found:
        raise CommandError(
            f"file '{name}' was not found in the share directory of package '{package}' which is at '{share}'"
        )
    if len(found) > 1:
        raise CommandError(
            f"file '{name}' was found more than once in the share directory of package '{package}': "
            f"[{', '.join(repr(str(path)) for path in found)}]"
        )
    return str(found[0])


def _files_below(folder: str) -> list[Path]:
    # A package of the underlay is made of links to folders.
    walked = os.walk(folder, followlinks=True)
    return [Path(root) / name for root, _, names in walked for name in sorted(names)]


def _pair(word: str) -> tuple[str, str]:
    name, separator, value = word.partition(":=")
    if not separator or not name:
        raise CommandError(f"malformed launch argument '{word}', expected format '<name>:=<value>'")
    return name, value


# -- what is in it -----------------------------------------------------------------------------------------


def _print_description(path: str) -> None:
    from launch import LaunchIntrospector

    print(LaunchIntrospector().format_launch_description(_loaded(path)))


def _print_arguments(path: str) -> None:
    arguments = _loaded(path).get_launch_arguments()
    print("Arguments (pass arguments as '<name>:=<value>'):")
    if not arguments:
        print("\n  No arguments.")
    for argument in arguments:
        print("\n" + "\n".join(_told(argument)))


def _told(argument: DeclareLaunchArgument) -> list[str]:
    lines = [f"    '{argument.name}':"]
    lines += [f"        {line}" for line in argument.description.splitlines()]
    if argument.default_value is not None:
        default = " + ".join(sub.describe() for sub in argument.default_value)
        lines.append(f"        (default: {default})")
    return lines


def _loaded(path: str) -> LaunchDescription:
    from launch.launch_description_sources import get_launch_description_from_any_launch_file

    try:
        return get_launch_description_from_any_launch_file(path)
    except Exception as error:
        raise CommandError(str(error)) from error


# -- run ---------------------------------------------------------------------------------------------------


def _launch(path: str, given: list[tuple[str, str]], args: argparse.Namespace) -> int:
    from launch import LaunchDescription
    from launch.actions import IncludeLaunchDescription
    from launch.launch_description_sources import AnyLaunchDescriptionSource

    service = _service(path, args)
    include = IncludeLaunchDescription(AnyLaunchDescriptionSource(path), launch_arguments=given)
    service.include_launch_description(LaunchDescription([include]))
    code = service.run()
    if service.ended_by_signal is not None:
        _die_of(service.ended_by_signal)
    return code


def _service(path: str, args: argparse.Namespace) -> LaunchService:
    from launch import LaunchService

    try:
        return LaunchService(argv=[path], noninteractive=args.noninteractive, debug=args.debug)
    except OSError as error:
        raise CommandError(f"cannot write log files: {error}") from error


def _die_of(number: int) -> None:
    """As if the signal had not been caught, now that everything is cleaned up."""
    import atexit

    sys.stdout.flush()
    atexit._run_exitfuncs()
    signal.signal(number, signal.SIG_DFL)
    os.kill(os.getpid(), number)


# -- completion --------------------------------------------------------------------------------------------


def _packages(prefix: str, **_: Any) -> list[str]:
    from ament_index_python.packages import get_packages_with_prefixes

    return sorted(name for name in get_packages_with_prefixes() if name.startswith(prefix))


def _launch_files(prefix: str, parsed_args: argparse.Namespace, **_: Any) -> list[str]:
    from ament_index_python.packages import PackageNotFoundError, get_package_share_directory

    try:
        share = get_package_share_directory(parsed_args.package_name, print_warning=False)
    except (PackageNotFoundError, ValueError):
        return []
    return sorted({path.name for path in _files_below(share) if _FILE_NAME.match(path.name)})


def _arguments(prefix: str, parsed_args: argparse.Namespace, **_: Any) -> list[str]:
    try:
        path, _words = _file_and_words(parsed_args)
        return [f"{argument.name}:=" for argument in _loaded(path).get_launch_arguments()]
    except CommandError:
        return []
