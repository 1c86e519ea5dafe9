"""`ros2 param describe`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Iterator
from typing import Any

from ros2cli.arguments import add_completed
from ros2cli.param_types import kind
from ros2cli.params import add_node_argument, add_param_arguments, add_timeout, parameter_names, remote_node


def add_arguments(parser: ArgumentParser) -> None:
    add_param_arguments(parser)
    add_node_argument(parser)
    text = "Names of the parameter to describe"
    add_completed(parser, "parameter_names", parameter_names, nargs="+", help=text)
    add_timeout(parser)


def main(args: Namespace) -> None:
    with remote_node(args) as remote:
        descriptors = remote.describe(args.parameter_names)
    for descriptor in descriptors:
        print("\n".join(_lines(descriptor)))


def _lines(descriptor: Any) -> Iterator[str]:
    yield f"Parameter name: {descriptor.name}"
    yield f"  Type: {kind(descriptor.type).name}"
    if descriptor.description:
        yield f"  Description: {descriptor.description}"
    yield "  Constraints:"
    if descriptor.read_only:
        yield "    Read only: true"
    for bounds in [*descriptor.floating_point_range, *descriptor.integer_range]:
        yield f"    Min value: {bounds.from_value}"
        yield f"    Max value: {bounds.to_value}"
        if bounds.step:
            yield f"    Step: {bounds.step}"
    if descriptor.additional_constraints:
        yield f"    Additional constraints: {descriptor.additional_constraints}"
