"""Tags about what is done when: includes, groups, timers, loops."""

from __future__ import annotations

from typing import Any

from launch import actions
from launch.frontend.entity import Entity
from launch.frontend.tags.values import pairs


def _include(entity: Entity, parser: Any) -> Any:
    return actions.IncludeLaunchDescription, {
        "launch_description_source": parser.parse_substitution(entity.get_attr("file")),
        "launch_arguments": [*pairs(entity, parser, "arg"), *pairs(entity, parser, "let")],
    }


def _group(entity: Entity, parser: Any) -> Any:
    kept = pairs(entity, parser, "keep")
    scoped = entity.get_attr("scoped", data_type=bool, optional=True)
    forwarding = entity.get_attr("forwarding", data_type=bool, optional=True)
    return actions.GroupAction, {
        "actions": [parser.parse_action(each) for each in entity.children if each.type_name != "keep"],
        "scoped": True if scoped is None else scoped,
        "forwarding": True if forwarding is None else forwarding,
        "launch_configurations": {tuple(name): value for name, value in kept},
    }


def _timer(entity: Entity, parser: Any) -> Any:
    period = parser.parse_substitution(entity.get_attr("period"))
    return actions.TimerAction, {
        "period": period,
        "actions": [parser.parse_action(each) for each in entity.children],
    }


def _log(entity: Entity, parser: Any) -> Any:
    level = entity.get_attr("level", optional=True)
    message = parser.parse_substitution(entity.get_attr("message"))
    return actions.Log, {"msg": message, "level": level or "INFO"}


def _log_as(level: str) -> Any:
    return lambda entity, parser: (
        actions.Log,
        {"msg": parser.parse_substitution(entity.get_attr("message")), "level": level},
    )


def _shutdown(entity: Entity, parser: Any) -> Any:
    reason = entity.get_attr("reason", optional=True)
    return actions.Shutdown, {} if reason is None else {"reason": reason}


def _for(entity: Entity, parser: Any) -> Any:
    name = entity.get_attr("name")
    below = entity.children
    return actions.ForLoop, {
        "length": parser.parse_substitution(entity.get_attr("len")),
        "function": lambda index: _one_round(below, parser, {name: index}),
    }


def _for_each(entity: Entity, parser: Any) -> Any:
    below = entity.children
    return actions.ForEach, {
        "input_values": parser.parse_substitution(entity.get_attr("values")),
        "function": lambda **values: _one_round(below, parser, values),
    }


def _one_round(below: list[Entity], parser: Any, values: dict[str, Any]) -> list[Any]:
    """Actions of its own for each round: a process is started once by one action."""

    def enter(context: Any) -> None:
        outside = context.get_locals_as_dict().get("loop_values", {})
        context.extend_locals({"loop_values": {**outside, **values}})

    return [actions.OpaqueFunction(function=enter), *(parser.parse_action(each) for each in below)]


TAGS = {
    "for": _for,
    "for_each": _for_each,
    "group": _group,
    "include": _include,
    "log": _log,
    "log_debug": _log_as("DEBUG"),
    "log_error": _log_as("ERROR"),
    "log_info": _log_as("INFO"),
    "log_warning": _log_as("WARNING"),
    "shutdown": _shutdown,
    "timer": _timer,
}
