"""`ros2 topic list`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli.arguments import add_hidden
from ros2cli.graph import add_graph_arguments, graph
from ros2cli.snapshot import Snapshot


def add_arguments(parser: ArgumentParser) -> None:
    add_graph_arguments(parser)
    parser.add_argument("-t", "--show-types", action="store_true", help="Additionally show the topic type")
    parser.add_argument(
        "-c", "--count-topics", action="store_true", help="Only display the number of topics discovered"
    )
    add_hidden(parser, "topics")
    parser.add_argument(
        "-v", "--verbose", action="store_true",
        help="List full details about each topic",
    )  # fmt: skip


def main(args: Namespace) -> None:
    known = graph(args)
    topics = known.topics(hidden=args.include_hidden_topics)
    if args.count_topics:
        print(len(topics))
    elif args.verbose:
        _print_sides(known, topics)
    else:
        for name, types in topics.items():
            print(f"{name} [{', '.join(types)}]" if args.show_types else name)


def _print_sides(known: Snapshot, topics: dict[str, list[str]]) -> None:
    print("Published topics:")
    for name, types in topics.items():
        _print_count(name, types, len(known.publishers(name)), "publisher")
    print("\nSubscribed topics:")
    for name, types in topics.items():
        _print_count(name, types, len(known.subscriptions(name)), "subscriber")
    print()


def _print_count(name: str, types: list[str], count: int, noun: str) -> None:
    if count:
        print(f" * {name} [{', '.join(types)}] {count} {noun}{'s' if count > 1 else ''}")
