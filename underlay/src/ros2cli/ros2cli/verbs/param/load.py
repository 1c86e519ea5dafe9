"""`ros2 param load`."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from typing import Any

from ros2cli.errors import CommandError
from ros2cli.params import add_node_argument, add_param_arguments, add_timeout, remote_node


def add_arguments(parser: ArgumentParser) -> None:
    add_param_arguments(parser)
    add_node_argument(parser)
    parser.add_argument("parameter_file", help="Parameter file")
    parser.add_argument(
        "--no-use-wildcard",
        action="store_true",
        help="Do not load parameters in the '/**' namespace into the node",
    )
    add_timeout(parser)


def main(args: Namespace) -> None:
    parameters = _read(args.parameter_file, wildcard=not args.no_use_wildcard)
    with remote_node(args) as remote:
        results = remote.set(parameters)
    for parameter, result in zip(parameters, results, strict=True):
        reason = f": {result.reason}" if result.reason else ""
        outcome = "successful" if result.successful else "failed"
        print(
            f"Set parameter {parameter.name} {outcome}{reason}",
            file=None if result.successful else sys.stderr,
        )


def _read(file: str, *, wildcard: bool) -> list[Any]:
    import yaml
    from rclpy.parameter import parameter_dict_from_yaml_file

    try:
        return list(parameter_dict_from_yaml_file(file, wildcard).values())
    except (OSError, UnicodeDecodeError) as error:
        raise CommandError(f"Cannot read '{file}': {getattr(error, 'strerror', None) or error}") from error
    except yaml.YAMLError as error:
        raise CommandError(f"'{file}' is not valid YAML: {_one_line(error)}") from error
    except (AttributeError, TypeError, KeyError, AssertionError) as error:
        raise CommandError(f"'{file}' is not a valid ROS parameter file") from error


def _one_line(error: Exception) -> str:
    return " ".join(str(error).split())
