"""`ros2 pkg list`: the names of all packages."""

import argparse

from ament_index_python.packages import get_packages_with_prefixes


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take no arguments."""


def main(args: argparse.Namespace) -> None:
    """Print one name a line."""
    for name in sorted(get_packages_with_prefixes()):
        print(name)
