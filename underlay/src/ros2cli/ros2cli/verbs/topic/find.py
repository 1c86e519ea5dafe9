"""`ros2 topic find`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli.arguments import add_completed, add_hidden
from ros2cli.complete import all_topic_types
from ros2cli.graph import add_graph_arguments, graph


def add_arguments(parser: ArgumentParser) -> None:
    add_graph_arguments(parser)
    text = "Name of the ROS topic type to filter for (e.g. 'std_msgs/msg/String')"
    add_completed(parser, "topic_type", all_topic_types, help=text)
    parser.add_argument(
        "-c", "--count-topics", action="store_true", help="Only display the number of topics discovered"
    )
    add_hidden(parser, "topics")


def main(args: Namespace) -> None:
    topics = graph(args).topics(hidden=args.include_hidden_topics)
    found = [name for name, types in topics.items() if args.topic_type in types]
    print(len(found)) if args.count_topics else print("".join(f"{name}\n" for name in found), end="")
