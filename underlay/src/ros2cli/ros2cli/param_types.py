"""The types that a parameter may have, and where a message keeps a value of each."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Kind:
    name: str
    field: str
    label: str


# In the order of the numbers of rcl_interfaces/msg/ParameterType.
_KINDS = (
    Kind("not set", "", "Parameter not set."),
    Kind("boolean", "bool_value", "Boolean value is:"),
    Kind("integer", "integer_value", "Integer value is:"),
    Kind("double", "double_value", "Double value is:"),
    Kind("string", "string_value", "String value is:"),
    Kind("byte array", "byte_array_value", "Byte values are:"),
    Kind("boolean array", "bool_array_value", "Boolean values are:"),
    Kind("integer array", "integer_array_value", "Integer values are:"),
    Kind("double array", "double_array_value", "Double values are:"),
    Kind("string array", "string_array_value", "String values are:"),
)


def kind(number: int) -> Kind:
    return _KINDS[number] if 0 <= number < len(_KINDS) else Kind(f"unknown type {number}", "", "Unknown type")


def value_of(message: Any) -> Any:
    """The value in a rcl_interfaces/msg/ParameterValue; None when it holds none."""
    field = kind(message.type).field
    return getattr(message, field) if field else None


def plain_value_of(message: Any) -> Any:
    """The same, with lists as lists, for YAML."""
    value = value_of(message)
    if message.type == 5:
        return [int.from_bytes(byte, "little") for byte in value]
    return value if value is None or isinstance(value, (str, bool, int, float)) else list(value)
