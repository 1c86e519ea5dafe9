"""`ros2 pkg prefix`: where a package is installed."""

import argparse

from ros2cli.verbs.pkg.installed import packages, prefix_of


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take the package, and whether its share folder is wanted."""
    name = parser.add_argument("package_name", help="The package name")
    name.completer = packages  # type: ignore[attr-defined]  # argcomplete's way
    parser.add_argument("--share", action="store_true", help="Show share directory for the package")


def main(args: argparse.Namespace) -> None:
    """Print the folder."""
    prefix = prefix_of(args.package_name, "Package not found")
    print(prefix / "share" / args.package_name if args.share else prefix)
