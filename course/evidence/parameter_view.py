"""A node's parameters as checks see them: what it answered, what was set, what it announced."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import inf
from typing import Any

from course.evidence.service_view import ServiceCall
from course.evidence.topic_view import Message

EVENTS = "/parameter_events"
EVENTS_TYPE = "rcl_interfaces/msg/ParameterEvent"


@dataclass(frozen=True)
class Parameter:
    """A parameter at one moment: its name, its ROS type, its value (lists as tuples).

    t: when the node answered or announced it (s).
    """

    t: float
    name: str
    type: str
    value: Any


@dataclass(frozen=True)
class SetResult:
    """One parameter that the scenario set. successful: None if no answer came.

    asked, answered: when (s). reason: as the node stated it.
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
    """What is known about one node's parameters.

    asked: whether the scenario asked the node anything. answered: whether it ever answered. names: from its
    last list. readings: the values it returned, by time. undeclared: names that were asked for but have no
    value. sets: what the scenario set. changes: what the node announced on /parameter_events. descriptors:
    the last one of each name.
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
    def of(
        cls, node: str, calls_of: Callable[[str], tuple[ServiceCall, ...]], announced: tuple[Message, ...]
    ) -> ParameterView:
        """calls_of: gives the arena's calls of a service, by its full name. announced: those on `EVENTS`."""

        def calls(name: str) -> tuple[ServiceCall, ...]:
            return calls_of(f"{node}/{name}")

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
            _changes(node, announced),
            {found.name: found for call in describes if call.response for found in call.response.descriptors},
        )

    def at(self, t: float = inf) -> dict[str, Parameter]:
        """Return each parameter by name, with the value last reported by the node up to the time `t` (s)."""
        return {found.name: found for found in self.readings if found.t <= t}

    def get(self, name: str, t: float = inf) -> Parameter | None:
        """Return the parameter as the node last reported it up to the time `t` (s); None if it never did."""
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
    read = {found.name for found in _read(call)}
    return [name for name in call.request.names if name not in read]


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


def _changes(node: str, announced: tuple[Message, ...]) -> tuple[Parameter, ...]:
    return tuple(
        Parameter(message.t, found.name, *from_message(found.value))
        for message in announced
        if message.data and message.data.node == node
        for found in (*message.data.new_parameters, *message.data.changed_parameters)
    )


# By number in rcl_interfaces/msg/ParameterType: the type's name, and the field of ParameterValue.
_TYPES = (
    ("not set", ""),
    ("bool", "bool_value"),
    ("integer", "integer_value"),
    ("double", "double_value"),
    ("string", "string_value"),
    ("byte array", "byte_array_value"),
    ("bool array", "bool_array_value"),
    ("integer array", "integer_array_value"),
    ("double array", "double_array_value"),
    ("string array", "string_array_value"),
)
NOT_SET = "not set"
ParameterData = bool | int | float | str | bytes | list[bool] | list[int] | list[float] | list[str]
# bool before int: True is an int too.
_PLAIN = ((bool, "bool"), (int, "integer"), (float, "double"), (str, "string"))


def type_name(value: ParameterData) -> str:
    """The ROS type of a Python value: `string`, `double array`. Raises ValueError if it has none."""
    if isinstance(value, bytes):
        return "byte array"
    if isinstance(value, list):
        return f"{type_name(value[0])} array" if value else "string array"
    for kind, name in _PLAIN:
        if isinstance(value, kind):
            return name
    raise ValueError(f"a parameter cannot be {value!r}")


def to_fields(value: ParameterData) -> dict[str, Any]:
    """The fields of an rcl_interfaces/msg/ParameterValue with this value."""
    name = type_name(value)
    number, field = next((n, field) for n, (known, field) in enumerate(_TYPES) if known == name)
    data = [bytes([byte]) for byte in value] if isinstance(value, bytes) else value
    return {"type": number, field: data}


def from_message(message: Any) -> tuple[str, Any]:
    """Type and value of an rcl_interfaces/msg/ParameterValue, with lists as tuples."""
    if not 0 < message.type < len(_TYPES):
        return NOT_SET, None
    name, field = _TYPES[message.type]
    value = getattr(message, field)
    return name, tuple(value) if name.endswith("array") else value
