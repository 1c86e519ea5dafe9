"""The options that choose how messages are shown, and what they mean for the conversions."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import Any

_LENGTH = 128


def add_form_arguments(parser: ArgumentParser, *, with_field: bool = False) -> None:
    add = parser.add_argument
    add("--csv", action="store_true", help="Print all fields in one line, separated by commas")
    if with_field:
        text = "Print only this field; a part of a field is written with dots (e.g. pose.pose.position)"
        add("--field", help=text)
    text = "Print arrays, bytes and strings of any length in full"
    add("--full-length", "-f", action="store_true", help=text)
    text = f"The length to truncate arrays, bytes, and string to (default: {_LENGTH})"
    add("--truncate-length", "-l", type=int, default=_LENGTH, help=text)
    add("--no-arr", action="store_true", help="Don't print array fields of messages")
    add("--no-str", action="store_true", help="Don't print string fields of messages")
    add("--flow-style", action="store_true", help="Print arrays in one line (not with --csv)")


def limits(args: Namespace) -> dict[str, Any]:
    """What the functions of rosidl_runtime_py are to leave out."""
    return {
        "truncate_length": None if args.full_length else args.truncate_length,
        "no_arr": args.no_arr,
        "no_str": args.no_str,
    }
