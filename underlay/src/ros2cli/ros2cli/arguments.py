"""Arguments that several verbs share."""

from __future__ import annotations

import argparse
from argparse import ArgumentParser
from typing import Any


def add_hidden(parser: ArgumentParser, what: str) -> None:
    """`--include-hidden-<what>` of a verb, which the command may have been given before it."""
    parser.add_argument(
        f"--include-hidden-{what}",
        action="store_true",
        default=argparse.SUPPRESS,
        help=f"Consider hidden {what} as well",
    )


def add_completed(parser: ArgumentParser, name: str, completer: Any, **options: Any) -> None:
    """An argument that the Tab key knows values for."""
    parser.add_argument(name, **options).completer = completer  # type: ignore[attr-defined]


def positive_int(text: str) -> int:
    value = int(text)
    if value <= 0:
        raise argparse.ArgumentTypeError("value must be a positive integer")
    return value


def positive_float(text: str) -> float:
    value = float(text)
    if not value > 0.0:
        raise argparse.ArgumentTypeError("value must be a positive float")
    return value


def non_negative_int(text: str) -> int:
    value = int(text)
    if value < 0:
        raise argparse.ArgumentTypeError("value must be a non-negative integer")
    return value
