"""The many ways to write parameters, made one: files, and dicts whose names are flat."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from launch.action import texts
from launch.substitution import Substitution

from launch_ros.parameter_descriptions import Parameter, ParameterFile, ParameterValue

Normal = Any  # ParameterFile, Parameter, or a dict of names to values


class Concatenation(list[Substitution]):
    """Substitutions that make one text, whose type is then guessed."""


def normalize_parameters(parameters: Iterable[Any]) -> tuple[Normal, ...]:
    if isinstance(parameters, str) or not isinstance(parameters, Iterable):
        raise TypeError("Expecting list of parameters, got {}".format(parameters))  # noqa: UP032
    return tuple(_normal(parameter) for parameter in parameters)


def _normal(parameter: Any) -> Normal:
    if isinstance(parameter, Mapping):
        return normalize_parameter_dict(parameter)
    if isinstance(parameter, ParameterFile | Parameter):
        return parameter
    if isinstance(parameter, str | Path | Substitution | list | tuple):
        return ParameterFile(parameter)
    raise TypeError(f"parameters are dicts, files or Parameter objects, got {parameter!r}")


def normalize_parameter_dict(parameters: Mapping[Any, Any], *, above: object = ()) -> dict[Any, Any]:
    """Names are tuples of substitutions; a dict within a dict puts `outer.` before its names."""
    normal: dict[Any, Any] = {}
    for name, value in parameters.items():
        full = (*_parts(above), *_parts(name))
        if isinstance(value, Mapping):
            normal.update(normalize_parameter_dict(value, above=(*full, *_parts("."))))
        else:
            normal[full] = value if isinstance(value, ParameterValue) else normalize_value(value)
    return normal


def _parts(name: Any) -> tuple[Substitution, ...]:
    return tuple(texts(name))


def normalize_value(value: Any) -> Any:
    """Plain values stay; whatever holds substitutions becomes a Concatenation, or a list of them."""
    if isinstance(value, Substitution):
        return Concatenation([value])
    if isinstance(value, str | bytes | bool | int | float):
        return value
    if isinstance(value, Path):
        return str(value)
    if isinstance(value, Sequence):
        return _normal_sequence(value)
    raise TypeError("Unexpected type for parameter value {}".format(repr(value)))  # noqa: UP032


def _normal_sequence(values: Sequence[Any]) -> Any:
    if any(isinstance(value, Substitution) for value in values):
        return Concatenation(texts(values))
    if any(_is_nested(value) for value in values):
        return [Concatenation(texts(value)) for value in values]
    return _one_type(values)


def _is_nested(value: object) -> bool:
    return isinstance(value, list | tuple)


def _one_type(values: Sequence[Any]) -> list[Any]:
    """ROS knows no mixed lists: whole numbers among others become such, anything else text."""
    kinds = {type(value) for value in values}
    if len(kinds) <= 1:
        return list(values)
    return [float(value) for value in values] if kinds == {int, float} else [str(value) for value in values]
