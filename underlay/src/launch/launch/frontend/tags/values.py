"""Tags about arguments, configurations and the environment."""

from __future__ import annotations

from typing import Any

from launch import actions
from launch.frontend.entity import Entity

_List = list[Entity]


def _named(kind: Any, *attributes: str, **optional: str) -> Any:
    """A tag whose attributes are arguments of the same names; `optional` ones may be absent."""

    def parse(entity: Entity, parser: Any) -> Any:
        kwargs = {name: parser.parse_substitution(entity.get_attr(name)) for name in attributes}
        for name, argument in optional.items():
            given = entity.get_attr(name, optional=True)
            if given is not None:
                kwargs[argument] = parser.parse_substitution(given)
        return kind, kwargs

    return parse


def _arg(entity: Entity, parser: Any) -> Any:
    default = entity.get_attr("default", optional=True)
    choices = entity.get_attr("choice", data_type=_List, optional=True)
    kwargs = {
        "name": entity.get_attr("name"),
        "default_value": None if default is None else parser.parse_substitution(default),
        "description": entity.get_attr("description", optional=True),
        "choices": None if choices is None else [_completed(choice, "value") for choice in choices],
    }
    return actions.DeclareLaunchArgument, kwargs


def _completed(entity: Entity, name: str) -> str:
    value: str = entity.get_attr(name)
    entity.assert_entity_completely_parsed()
    return value


def pairs(entity: Entity, parser: Any, tag: str, first: str = "name", second: str = "value") -> list[Any]:
    """The tags of a name below `entity`, as pairs of substitutions."""
    found = []
    for each in entity.get_attr(tag, data_type=_List, optional=True) or ():
        pair = (
            parser.parse_substitution(each.get_attr(first)),
            parser.parse_substitution(each.get_attr(second)),
        )
        each.assert_entity_completely_parsed()
        found.append(pair)
    return found


def _reset(entity: Entity, parser: Any) -> Any:
    kept = [(tuple(name), value) for name, value in pairs(entity, parser, "keep")]
    return actions.ResetLaunchConfigurations, {"launch_configurations": dict(kept)}


def _plain(kind: Any) -> Any:
    return lambda entity, parser: (kind, {})


TAGS = {
    "append_env": _named(
        actions.AppendEnvironmentVariable, "name", "value", prepend="prepend", separator="separator"
    ),
    "arg": _arg,
    "let": _named(actions.SetLaunchConfiguration, "name", "value"),
    "pop_environment": _plain(actions.PopEnvironment),
    "pop_launch_configurations": _plain(actions.PopLaunchConfigurations),
    "push_environment": _plain(actions.PushEnvironment),
    "push_launch_configurations": _plain(actions.PushLaunchConfigurations),
    "reset": _reset,
    "reset_environment": _plain(actions.ResetEnvironment),
    "set_env": _named(actions.SetEnvironmentVariable, "name", "value"),
    "unlet": _named(actions.UnsetLaunchConfiguration, "name"),
    "unset_env": _named(actions.UnsetEnvironmentVariable, "name"),
}
