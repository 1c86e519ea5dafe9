"""A launch description as a tree of text, without running it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from launch.actions.emit_event import EmitEvent
from launch.actions.execute_process import ExecuteProcess
from launch.actions.log_info import Log
from launch.actions.register_event_handler import RegisterEventHandler
from launch.launch_description import LaunchDescription
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.substitution import Substitution


class LaunchIntrospector:
    """`format_launch_description` gives one text with lines."""

    def format_launch_description(self, launch_description: LaunchDescription) -> str:
        return "\n".join([str(launch_description), *_branches(_entities(launch_description.entities))])


def _entities(entities: Iterable[LaunchDescriptionEntity]) -> list[list[str]]:
    return [_entity(entity) for entity in entities]


def _entity(entity: LaunchDescriptionEntity) -> list[str]:
    """The lines of one entity, with those below it."""
    if isinstance(entity, LaunchDescription):
        return [str(entity), *_branches(_entities(entity.entities))]
    below = entity.describe_sub_entities() if not isinstance(entity, ExecuteProcess) else []
    return [_line(entity), *_below(entity), *_branches(_entities(below))]


def _below(entity: LaunchDescriptionEntity) -> list[str]:
    """What an event handler does."""
    if not isinstance(entity, RegisterEventHandler):
        return []
    text, entities = entity.event_handler.describe()
    return _branches([[text, *_branches(_entities(entities))]])


def _line(entity: LaunchDescriptionEntity) -> str:
    if isinstance(entity, Log):
        return f"LogInfo({_texts(entity.msg)})"
    if isinstance(entity, EmitEvent):
        return f"EmitEvent(event='{entity.event.name}')"
    if isinstance(entity, ExecuteProcess):
        return _process(entity)
    if isinstance(entity, RegisterEventHandler):
        return f"RegisterEventHandler('{entity.event_handler}'):"
    return f"Action('{entity}')"


def _process(entity: ExecuteProcess) -> str:
    cmd = ", ".join(_texts(part) for part in entity.cmd)
    cwd = None if entity.cwd is None else _texts(entity.cwd)
    return f"ExecuteProcess(cmd=[{cmd}], cwd={cwd}, env={_environment(entity.env)}, shell={entity.shell})"


def _environment(env: Any) -> str | None:
    if env is None:
        return None
    return "{" + ", ".join(f"{_texts(name)}: {_texts(value)}" for name, value in env) + "}"


def _texts(subs: Iterable[Substitution]) -> str:
    return " + ".join(sub.describe() for sub in subs)


def _branches(children: list[list[str]]) -> list[str]:
    """The children of one node, joined to it by lines."""
    lines: list[str] = []
    for index, child in enumerate(children):
        first, rest = ("└── ", "    ") if index == len(children) - 1 else ("├── ", "│   ")
        lines += [(first if not row else rest) + text for row, text in enumerate(child)]
    return lines
