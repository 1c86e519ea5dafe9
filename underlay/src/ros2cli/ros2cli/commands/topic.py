"""`ros2 topic`: what may stand before the verb."""

from __future__ import annotations

from argparse import ArgumentParser


def add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("--include-hidden-topics", action="store_true", help="Consider hidden topics as well")
