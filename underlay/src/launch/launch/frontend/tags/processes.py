"""The tag of a process, and what a node has in common with it."""

from __future__ import annotations

from typing import Any

from launch import actions
from launch.frontend.entity import Entity
from launch.frontend.tags.values import pairs
from launch.frontend.words import split
from launch.substitution import Substitution

# Those of the second kind are texts that may hold substitutions.
_AS_IT_IS = {
    "cached_output": bool,
    "log_cmd": bool,
    "output_format": str,
    "respawn_max_retries": int,
    "shell": bool,
}
_TEXTS = (
    "cwd",
    "emulate_tty",
    "output",
    "respawn",
    "respawn_delay",
    "sigkill_timeout",
    "sigterm_timeout",
)


def process_arguments(entity: Entity, parser: Any) -> dict[str, Any]:
    """Everything but what is run."""
    kwargs = {name: entity.get_attr(name, data_type=kind, optional=True) for name, kind in _AS_IT_IS.items()}
    for name in _TEXTS:
        text = entity.get_attr(name, optional=True)
        kwargs[name] = None if text is None else parser.parse_substitution(text)
    prefix = entity.get_attr("launch-prefix", optional=True)
    kwargs["prefix"] = None if prefix is None else parser.parse_substitution(prefix)
    kwargs["additional_env"] = [(tuple(name), value) for name, value in pairs(entity, parser, "env")] or None
    kwargs["on_exit"] = _on_exit(entity)
    return {name: value for name, value in kwargs.items() if value is not None}


def _on_exit(entity: Entity) -> Any:
    wanted = entity.get_attr("on_exit", optional=True)
    if wanted not in (None, "shutdown"):
        raise ValueError(
            f"Attribute on_exit of Entity {entity.type_name} found with value '{wanted}', allowed is "
            "'shutdown'"
        )
    return None if wanted is None else actions.Shutdown()


def words(text: str, parser: Any) -> list[list[Substitution]]:
    """A command line as its words, each of texts and substitutions; quotes hold what belongs together."""
    return [parser.parse_substitution(word) for word in split(text)]


def _executable(entity: Entity, parser: Any) -> Any:
    kwargs = process_arguments(entity, parser)
    text = entity.get_attr("cmd")
    # A shell splits what it is given.
    kwargs["cmd"] = [parser.parse_substitution(text)] if kwargs.get("shell") else words(text, parser)
    args = entity.get_attr("args", optional=True)
    kwargs["cmd"] += [] if args is None else words(args, parser)
    name = entity.get_attr("name", optional=True)
    kwargs["name"] = None if name is None else parser.parse_substitution(name)
    return actions.ExecuteProcess, kwargs


TAGS = {"executable": _executable}
