"""`ros2 pkg executables`: what can be run, of one package or of all."""

import argparse

from ros2cli.verbs.pkg.installed import executables, packages


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take the package, and whether paths are wanted."""
    name = parser.add_argument("package_name", nargs="?", help="The package name")
    name.completer = packages  # type: ignore[attr-defined]  # argcomplete's way
    parser.add_argument("--full-path", action="store_true", help="Show the full path of each executable")


def main(args: argparse.Namespace) -> None:
    """Print `package executable`, or the path alone."""
    for package in [args.package_name] if args.package_name else packages():
        for path in executables(package):
            print(path if args.full_path else f"{package} {path.name}")
