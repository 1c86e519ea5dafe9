"""Types of parameters by their ROS names, and values from Python to ROS and back."""

from __future__ import annotations

from typing import Any

# By the number in rcl_interfaces/msg/ParameterType: its name, and the field of ParameterValue.
_TYPES = (
    ("not set", ""),
    ("bool", "bool_value"),
    ("integer", "integer_value"),
    ("double", "double_value"),
    ("string", "string_value"),
    ("byte array", "byte_array_value"),
    ("bool array", "bool_array_value"),
    ("integer array", "integer_array_value"),
    ("double array", "double_array_value"),
    ("string array", "string_array_value"),
)
NOT_SET = "not set"
ParameterData = bool | int | float | str | bytes | list[bool] | list[int] | list[float] | list[str]
# bool before int: True is an int too.
_PLAIN = ((bool, "bool"), (int, "integer"), (float, "double"), (str, "string"))


def type_name(value: ParameterData) -> str:
    """The ROS type of a Python value: `string`, `double array`. Raises ValueError when it has none."""
    if isinstance(value, bytes):
        return "byte array"
    if isinstance(value, list):
        return f"{type_name(value[0])} array" if value else "string array"
    for kind, name in _PLAIN:
        if isinstance(value, kind):
            return name
    raise ValueError(f"a parameter cannot be {value!r}")


def to_fields(value: ParameterData) -> dict[str, Any]:
    """The fields of an rcl_interfaces/msg/ParameterValue with this value."""
    name = type_name(value)
    number, field = next((n, field) for n, (known, field) in enumerate(_TYPES) if known == name)
    data = [bytes([byte]) for byte in value] if isinstance(value, bytes) else value
    return {"type": number, field: data}


def from_message(message: Any) -> tuple[str, Any]:
    """Type and value of an rcl_interfaces/msg/ParameterValue; lists are given as tuples."""
    if not 0 < message.type < len(_TYPES):
        return NOT_SET, None
    name, field = _TYPES[message.type]
    value = getattr(message, field)
    return name, tuple(value) if name.endswith("array") else value
