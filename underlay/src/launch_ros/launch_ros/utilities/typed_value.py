"""From a text to a value of a type, told or guessed."""

from __future__ import annotations

import typing
from typing import Any

import yaml

_PLAIN = (bool, int, float, str, bytes)
_TRY = (
    "If the parameter is meant to be a string, try wrapping it in "
    "launch_ros.parameter_descriptions.ParameterValue(value, value_type=str)"
)


def typed(text: str, kind: Any = None) -> Any:
    """`kind` is bool, int, float, str, a List of one of them, or None: then YAML decides."""
    if kind is str:
        return text
    value = _parsed(text)
    if kind is None:
        _require_allowed(value)
        return value
    return _as_kind(value, text, kind)


def guessed(text: str, name: str) -> Any:
    """YAML decides, and what goes wrong is told of the parameter `name`."""
    try:
        return typed(text)
    except yaml.YAMLError as error:
        raise ValueError(f"Unable to parse the value of parameter {name} as yaml. {_TRY}") from error


def _parsed(text: str) -> Any:
    value = yaml.safe_load(text)
    return "" if value is None else value


def _require_allowed(value: Any) -> None:
    items = value if isinstance(value, list) else [value]
    kinds = {type(item) for item in items}
    if not kinds <= set(_PLAIN) or len(kinds) > 1:
        raise TypeError(
            "Allowed value types are bytes, bool, int, float, str, Sequence[bool], Sequence[int], "
            f"Sequence[float], Sequence[str]. Got {type(value)}.{_TRY}"
        )


def _as_kind(value: Any, text: str, kind: Any) -> Any:
    inner = typing.get_args(kind)
    if inner:
        if not isinstance(value, list):
            raise ValueError(f"Failed to convert '{text}' to '{kind}'")
        return [_as_kind(item, str(item), inner[0]) for item in value]
    if kind is str:
        return text
    if kind is float and type(value) is int:
        return float(value)
    if type(value) is not kind:
        raise ValueError(f"Failed to convert '{text}' to '{kind.__name__}'")
    return value
