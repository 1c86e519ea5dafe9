"""Attributes as values of a type. A text with a substitution in it stays a text: its value comes later."""

from __future__ import annotations

import typing
from typing import Any

import yaml

_SCALARS = (bool, int, float, str)


def has_substitution(value: object) -> bool:
    return isinstance(value, str) and "$(" in value


def typed_attribute(value: Any, kind: Any, what: str) -> Any:
    """`kind` is a scalar type, a List of one, or None for what YAML takes it for.

    Raises TypeError that names the attribute, as `what` calls it.
    """
    if isinstance(value, list):
        inner = (typing.get_args(kind) or (None,))[0]
        return [typed_attribute(item, inner, what) for item in value]
    if has_substitution(value):
        return value
    if kind is str:
        return str(value).lower() if isinstance(value, bool) else str(value)
    return _converted(value, kind, what)


def _converted(value: Any, kind: Any, what: str) -> Any:
    found = guessed_scalar(value) if isinstance(value, str) else value
    if kind is None or type(found) is kind:
        return found
    if kind is float and type(found) is int:
        return float(found)
    if kind is bool and found in (0, 1):
        return bool(found)
    raise TypeError(f"{what} is expected to be of type '{kind}', got '{value}'")


def guessed_scalar(text: str) -> Any:
    """A truth value or a number where YAML says so, else the text; quotes make it one."""
    try:
        value = yaml.safe_load(text)
    except yaml.YAMLError:
        return text
    return value if isinstance(value, _SCALARS) else text
