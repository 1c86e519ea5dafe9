"""Messages, requests and goals from the YAML that was typed."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ros2cli.errors import CommandError


def from_yaml(text: str) -> Any:
    """CommandError, in one line, for what is not YAML."""
    import yaml

    try:
        return yaml.safe_load(text)
    except yaml.YAMLError as error:
        raise CommandError(f"The passed value is not valid YAML: {' '.join(str(error).split())}") from error


def fill(message: Any, values: Any, *, at_publishing: bool = False) -> Callable[[Any], None]:
    """Set the fields of the message; returns what must be set again at each publishing."""
    from rosidl_runtime_py import set_message_fields

    try:
        if not at_publishing:
            set_message_fields(message, values)
            return lambda stamp: None
        setters = set_message_fields(message, values, expand_header_auto=True, expand_time_now=True)
    except Exception as error:  # setters of message classes assert, convert and compare
        raise CommandError(f"Failed to populate field: {error}") from error
    return _all_of(setters)


def _all_of(setters: Any) -> Callable[[Any], None]:
    def set_now(stamp: Any) -> None:
        for setter in setters or ():
            setter(stamp)

    return set_now
