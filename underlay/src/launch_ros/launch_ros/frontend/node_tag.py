"""The tag of a node."""

from __future__ import annotations

from typing import Any

from launch.frontend.entity import Entity
from launch.frontend.tags.processes import process_arguments, words
from launch.frontend.tags.values import pairs
from launch.frontend.type_utils import has_substitution

from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterFile, ParameterValue

_TYPES = {
    "bool": bool,
    "float": float,
    "int": int,
    "str": str,
    "list_of_bool": list[bool],
    "list_of_float": list[float],
    "list_of_int": list[int],
    "list_of_str": list[str],
}
_TEXTS = {
    "pkg": "package",
    "exec": "executable",
    "exec_name": "exec_name",
    "name": "name",
    "namespace": "namespace",
}
_WORDS = {"args": "arguments", "ros_args": "ros_arguments"}


def node(entity: Entity, parser: Any) -> Any:
    kwargs = process_arguments(entity, parser)
    for attribute, argument in _TEXTS.items():
        text = entity.get_attr(attribute, optional=attribute not in ("pkg", "exec"))
        if text is not None:
            kwargs[argument] = parser.parse_substitution(text)
    for attribute, argument in _WORDS.items():
        text = entity.get_attr(attribute, optional=True)
        kwargs[argument] = None if text is None else words(text, parser)
    kwargs["remappings"] = pairs(entity, parser, "remap", "from", "to")
    parameters = entity.get_attr("param", data_type=list[Entity], optional=True)
    kwargs["parameters"] = [_parameters(each, parser) for each in parameters or ()]
    return Node, kwargs


def _parameters(entity: Entity, parser: Any) -> Any:
    """A file, or a name with a value or with more of them below."""
    file = entity.get_attr("from", optional=True)
    if file is None:
        return dict([_named(entity, parser)])
    allow = entity.get_attr("allow_substs", optional=True)
    entity.assert_entity_completely_parsed()
    return ParameterFile(
        parser.parse_substitution(file), allow_substs=parser.parse_substitution(allow or "false")
    )


def _named(entity: Entity, parser: Any) -> tuple[Any, Any]:
    name = tuple(parser.parse_substitution(entity.get_attr("name")))
    below = entity.get_attr("param", data_type=list[Entity], optional=True)
    value = value_of(entity, parser) if below is None else dict(_named(each, parser) for each in below)
    entity.assert_entity_completely_parsed()
    return name, value


def value_of(entity: Entity, parser: Any) -> Any:
    """The attribute `value`, as what `type` says or as what it looks like."""
    told = entity.get_attr("type", optional=True)
    if told not in (None, "auto", "yaml") and told not in _TYPES:
        raise ValueError(f"Attribute 'type' of Entity '{entity.type_name}' is none of {sorted(_TYPES)}")
    kind: Any = _TYPES.get(told) if told else None
    value = entity.get_attr("value", data_type=kind)
    late = has_substitution(value) or (isinstance(value, list) and any(map(has_substitution, value)))
    if not late:
        return value
    substituted = parser.parse_if_substitutions(value)
    return substituted if kind is None else ParameterValue(substituted, value_type=kind)
