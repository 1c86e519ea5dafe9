"""Where the listing verbs get the graph from: the daemon when it runs, else a look of their own."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli.snapshot import Snapshot, from_data


def add_graph_arguments(parser: ArgumentParser) -> None:
    """The options that every verb has that looks at the graph."""
    add_direct_arguments(parser)
    parser.add_argument(
        "--no-daemon", action="store_true", help="Do not spawn nor use an already running daemon"
    )


def add_direct_arguments(parser: ArgumentParser) -> None:
    """The options of verbs that have a node of their own in any case."""
    parser.add_argument(
        "--spin-time", type=float, default=None,
        help="Spin time in seconds to wait for discovery (only applies when not using an "
        "already running daemon)",
    )  # fmt: skip
    parser.add_argument("-s", "--use-sim-time", action="store_true", help="Enable ROS simulation time")


def graph(args: Namespace) -> Snapshot:
    """The complete graph. Without a daemon it takes longer, so one is started for the next time."""
    from ros2cli import daemon

    if getattr(args, "no_daemon", False) or not daemon.is_allowed():
        return _look(args)
    told = daemon.ask("graph")
    if told is not None:
        return from_data(told)
    seen = _look(args)
    daemon.spawn()
    return seen


def _look(args: Namespace) -> Snapshot:
    from ros2cli.discovery import discover
    from ros2cli.rcl import quick_node

    with quick_node() as handle:
        return discover(handle, getattr(args, "spin_time", None))
