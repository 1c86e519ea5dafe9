"""Parameters as they are when a node starts: no substitutions are left."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from launch.launch_context import LaunchContext
from launch.utilities import perform_substitutions

from launch_ros.parameter_descriptions import Parameter, ParameterFile, ParameterValue
from launch_ros.utilities.parameter_forms import Concatenation
from launch_ros.utilities.typed_value import guessed, typed

Evaluated = Path | tuple[str, Any] | dict[str, Any]


def evaluate_parameters(context: LaunchContext, parameters: Iterable[Any]) -> tuple[Evaluated, ...]:
    """A path for a file, a pair for a Parameter, a dict of names and values for a dict."""
    return tuple(_evaluated(context, parameter) for parameter in parameters)


def _evaluated(context: LaunchContext, parameter: Any) -> Evaluated:
    if isinstance(parameter, ParameterFile | Parameter):
        return parameter.evaluate(context)
    return evaluate_parameter_dict(context, parameter)


def evaluate_parameter_dict(context: LaunchContext, parameters: Mapping[Any, Any]) -> dict[str, Any]:
    evaluated = {}
    for parts, value in parameters.items():
        name = perform_substitutions(context, parts)
        evaluated[name] = _of_name(context, name, value)
    return evaluated


def _of_name(context: LaunchContext, name: str, value: Any) -> Any:
    if isinstance(value, ParameterValue):
        return value.evaluate(context)
    if isinstance(value, Concatenation):
        return guessed(perform_substitutions(context, value), name)
    return evaluate_value(context, value, None)


def evaluate_value(context: LaunchContext, value: Any, kind: Any) -> Any:
    """A normal value (see normalize_value) as one of type `kind`, or as it is."""
    if isinstance(value, Concatenation):
        return typed(perform_substitutions(context, value), kind)
    if isinstance(value, list) and any(isinstance(item, Concatenation) for item in value):
        return [perform_substitutions(context, item) for item in value]
    return value if kind is None else _converted(value, kind)


def _converted(value: Any, kind: Any) -> Any:
    if isinstance(value, list):
        return value
    return typed(value if isinstance(value, str) else _text(value), kind)


def _text(value: Any) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)
