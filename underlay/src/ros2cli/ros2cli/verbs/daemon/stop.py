"""`ros2 daemon stop`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli import daemon


def add_arguments(parser: ArgumentParser) -> None:
    """It has none."""


def main(args: Namespace) -> str | None:
    if not daemon.is_running():
        print("The daemon is not running")
        return None
    if not daemon.stop():
        return "Failed to stop the daemon"
    print("The daemon has been stopped")
    return None
