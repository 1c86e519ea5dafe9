"""Values of parameters from what was typed."""

from __future__ import annotations

import yaml
from rcl_interfaces.msg import ParameterType, ParameterValue
from rclpy.parameter import get_parameter_value


def guessed_value(text: str) -> ParameterValue:
    """The value that the text means as YAML; anything that a parameter can't have is taken as text."""
    try:
        value = get_parameter_value(text)
    except (yaml.YAMLError, AssertionError, TypeError, ValueError, OverflowError):
        value = None
    # A mapping or a date ends up where only text may be.
    if value is None or not isinstance(value.string_value, str):
        return ParameterValue(type=ParameterType.PARAMETER_STRING, string_value=text)
    return value
