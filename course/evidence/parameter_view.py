"""A node's parameters as checks see them: what it answered, what was set, what it announced."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING, Any

from course.evidence.parameter_types import from_message
from course.evidence.service_view import ServiceCall

if TYPE_CHECKING:
    from course.evidence.recording import Recording

EVENTS = "/parameter_events"
EVENTS_TYPE = "rcl_interfaces/msg/ParameterEvent"


@dataclass(frozen=True)
class Parameter:
    """A parameter at one moment: its name, its type as ROS calls it, its value (lists as tuples).

    t: when the node answered or announced it (s).
    """

    t: float
    name: str
    type: str
    value: Any


@dataclass(frozen=True)
class SetResult:
    """One parameter that the scenario set. successful: None when no answer came.

    asked, answered: when (s). reason: the node's own words.
    """

    asked: float
    answered: float | None
    name: str
    type: str
    value: Any
    successful: bool | None
    reason: str


@dataclass(frozen=True)
class ParameterView:
    """What is known of one node's parameters.

    asked: whether the scenario asked the node anything. answered: whether it ever answered.
    names: as the node listed them last. readings: values as it gave them, by time.
    undeclared: names that it was asked for and does not have. sets: what the scenario set.
    changes: what the node announced on /parameter_events. descriptors: by name, the last ones.
    """

    node: str
    asked: bool
    answered: bool
    names: tuple[str, ...]
    readings: tuple[Parameter, ...]
    undeclared: tuple[str, ...]
    sets: tuple[SetResult, ...]
    changes: tuple[Parameter, ...]
    descriptors: Mapping[str, Any]

    @classmethod
    def of(cls, node: str, recording: Recording) -> ParameterView:
        def calls(name: str) -> tuple[ServiceCall, ...]:
            return recording.service(f"{node}/{name}").calls

        gets, lists, sets = calls("get_parameters"), calls("list_parameters"), calls("set_parameters")
        describes = calls("describe_parameters")
        every = (*gets, *lists, *sets, *describes)
        return cls(
            node,
            bool(every),
            any(call.response for call in every),
            next((tuple(call.response.result.names) for call in reversed(lists) if call.response), ()),
            tuple(sorted((found for call in gets for found in _read(call)), key=lambda found: found.t)),
            tuple(dict.fromkeys(name for call in gets for name in _missing(call))),
            tuple(result for call in sets for result in _results(call)),
            _changes(node, recording),
            {found.name: found for call in describes if call.response for found in call.response.descriptors},
        )

    def at(self, t: float = inf) -> dict[str, Parameter]:
        """By name, each parameter as the node gave it last up to the time `t`."""
        return {found.name: found for found in self.readings if found.t <= t}

    def get(self, name: str, t: float = inf) -> Parameter | None:
        """The parameter as the node gave it last up to the time `t`; None if it never did."""
        return self.at(t).get(name)


def _read(call: ServiceCall) -> list[Parameter]:
    if not call.response or len(call.response.values) != len(call.request.names):
        return []
    pairs = zip(call.request.names, call.response.values, strict=True)
    return [
        Parameter(call.answered or call.asked, name, *from_message(value))
        for name, value in pairs
        if value.type
    ]


def _missing(call: ServiceCall) -> list[str]:
    if not call.response:
        return []
    values = call.response.values or [None] * len(call.request.names)
    return [
        name for name, value in zip(call.request.names, values, strict=False) if not (value and value.type)
    ]


def _results(call: ServiceCall) -> list[SetResult]:
    results = list(call.response.results) if call.response else []
    found = []
    for index, parameter in enumerate(call.request.parameters):
        result = results[index] if index < len(results) else None
        found.append(
            SetResult(
                call.asked,
                call.answered,
                parameter.name,
                *from_message(parameter.value),
                bool(result.successful) if result else None,
                result.reason if result else "",
            )
        )
    return found


def _changes(node: str, recording: Recording) -> tuple[Parameter, ...]:
    return tuple(
        Parameter(message.t, found.name, *from_message(found.value))
        for message in recording.messages(EVENTS)
        if message.data and message.data.node == node
        for found in (*message.data.new_parameters, *message.data.changed_parameters)
    )
