"""`ros2 component types`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli.arguments import add_completed
from ros2cli.components import packages_with_types, types_of
from ros2cli.verbs.pkg.installed import packages


def add_arguments(parser: ArgumentParser) -> None:
    text = "Package name to look for registered components in"
    add_completed(parser, "package_name", packages, nargs="?", help=text)


def main(args: Namespace) -> str | None:
    if args.package_name is None:
        for package in packages_with_types():
            print("\n  ".join([package, *types_of(package)]))
        return None
    if args.package_name not in packages():
        return f"Unable to find package '{args.package_name}'"
    print("".join(f"{name}\n" for name in types_of(args.package_name)), end="")
    return None
