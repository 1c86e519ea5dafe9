"""`ros2 daemon stop`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli import daemon


def add_arguments(parser: ArgumentParser) -> None:
    """It has none."""


def main(args: Namespace) -> str | None:
    has_ended = daemon.stop()
    if has_ended is False:
        return "Failed to stop the daemon"
    print("The daemon is not running" if has_ended is None else "The daemon has been stopped")
    return None
