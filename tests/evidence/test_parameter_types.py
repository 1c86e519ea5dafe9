"""Values of parameters, from Python to ROS and back."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from course.evidence.parameter_view import NOT_SET, ParameterData, from_message, to_fields, type_name


@pytest.mark.parametrize(
    ("value", "name", "number"),
    [
        (True, "bool", 1),
        (1, "integer", 2),
        (0.5, "double", 3),
        ("0.5", "string", 4),
        (b"ab", "byte array", 5),
        ([True], "bool array", 6),
        ([1, 2], "integer array", 7),
        ([0.5], "double array", 8),
        (["a", ""], "string array", 9),
        ([], "string array", 9),
    ],
)
def test_values_go_there_and_come_back(value: ParameterData, name: str, number: int) -> None:
    fields = to_fields(value)
    assert (type_name(value), fields["type"]) == (name, number)
    back = from_message(SimpleNamespace(**fields))
    expected = [bytes([b]) for b in value] if isinstance(value, bytes) else value
    assert back == (name, tuple(expected) if isinstance(expected, list) else expected)


@pytest.mark.parametrize("number", [0, 10, 255])
def test_a_parameter_without_a_value(number: int) -> None:
    assert from_message(SimpleNamespace(type=number)) == (NOT_SET, None)


def test_what_no_parameter_can_be() -> None:
    with pytest.raises(ValueError, match="None"):
        type_name(None)  # type: ignore[arg-type]
