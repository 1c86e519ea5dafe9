"""`ros2 daemon start`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli import daemon


def add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("-d", "--debug", action="store_true", help="Print debug messages")


def main(args: Namespace) -> str | None:
    if not daemon.is_allowed():
        return "The daemon is not started while an exercise is being checked"
    if daemon.is_running():
        print("The daemon is already running")
        return None
    if not (daemon.start(print) if args.debug else daemon.start()):
        return "Failed to start the daemon"
    print("The daemon has been started")
    return None
