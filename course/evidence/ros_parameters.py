"""Asks a node about its parameters through its own services; every call is on the time line."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from course.evidence.parameter_types import ParameterData, to_fields
from course.evidence.parameter_view import EVENTS, EVENTS_TYPE
from course.evidence.ros_services import Call, Client
from course.evidence.ros_types import filled, load_type

if TYPE_CHECKING:
    from course.evidence.recorder import Recorder

_KINDS = {
    "get_parameters": "GetParameters",
    "list_parameters": "ListParameters",
    "describe_parameters": "DescribeParameters",
    "set_parameters": "SetParameters",
}


class Parameters:
    """The parameters of one node, asked from outside. Nothing here waits: `Call.done` tells.

    Made before the node is started, it also hears of the changes that the node announces.
    node: full name, such as `/talker`.
    """

    def __init__(self, recorder: Recorder, node: str) -> None:
        self.node = node
        recorder.subscribe(EVENTS, EVENTS_TYPE)
        self._clients = {
            name: Client(recorder, f"{node}/{name}", f"rcl_interfaces/srv/{kind}")
            for name, kind in _KINDS.items()
        }

    @property
    def available(self) -> bool:
        """Whether the node is there and would hear a call."""
        return all(client.available for client in self._clients.values())

    def get(self, *names: str) -> tuple[Call, ...]:
        """Ask for values, each by a call of its own: ROS answers nothing at all when one is not declared."""
        return tuple(self._clients["get_parameters"].call(names=[name]) for name in names)

    def list(self) -> Call:
        """Ask for the names of all parameters."""
        return self._clients["list_parameters"].call()

    def describe(self, *names: str) -> tuple[Call, ...]:
        """Ask for descriptors, each by a call of its own."""
        return tuple(self._clients["describe_parameters"].call(names=[name]) for name in names)

    def set(self, values: Mapping[str, ParameterData] | None = None, **more: ParameterData) -> Call:
        """Set parameters, each by itself, as `ros2 param set` does. A Python float is a double, and so on."""
        message = load_type("rcl_interfaces/msg/Parameter")
        parameters = [
            filled(message(), {"name": name, "value": to_fields(value)})
            for name, value in {**(values or {}), **more}.items()
        ]
        return self._clients["set_parameters"].call(parameters=parameters)
