"""`ros2 daemon status`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli import daemon


def add_arguments(parser: ArgumentParser) -> None:
    """It has none."""


def main(args: Namespace) -> None:
    print("The daemon is running" if daemon.is_running() else "The daemon is not running")
