"""Someone's parameters, asked for through the services that every node has."""

from __future__ import annotations

import time
from collections.abc import Sequence
from typing import Any

import rclpy
from rcl_interfaces.msg import Parameter, ParameterDescriptor, ParameterValue, SetParametersResult
from rcl_interfaces.srv import (
    DescribeParameters,
    GetParameters,
    ListParameters,
    SetParameters,
)
from rclpy.node import Node
from rclpy.qos import qos_profile_parameters
from rclpy.task import Future

from ros2cli.discovery import discover
from ros2cli.errors import CommandError
from ros2cli.node import handle_of, wait_until


class RemoteNode:
    """The node `name` as `node` sees it. Its methods raise CommandError where it cannot be asked."""

    def __init__(self, node: Node, name: str, timeout: float, patience: float | None = None) -> None:
        self.name = name
        self._node = node
        self._timeout = timeout
        self._patience = patience

    def get(self, names: Sequence[str]) -> list[ParameterValue]:
        """As many values as there are names, or none when one of them is not declared."""
        return list(self._call(GetParameters, "get_parameters", names=list(names)).values)

    def set(self, parameters: Sequence[Parameter]) -> list[SetParametersResult]:
        return list(self._call(SetParameters, "set_parameters", parameters=list(parameters)).results)

    def describe(self, names: Sequence[str]) -> list[ParameterDescriptor]:
        return list(self._call(DescribeParameters, "describe_parameters", names=list(names)).descriptors)

    def list_names(self, prefixes: Sequence[str] = ()) -> list[str]:
        result = self._call(ListParameters, "list_parameters", prefixes=list(prefixes)).result
        return sorted(result.names)

    def _call(self, kind: Any, service: str, **request: Any) -> Any:
        future = self._ask(kind, service, request)
        rclpy.spin_until_future_complete(self._node, future, timeout_sec=self._timeout)
        if not future.done():
            raise CommandError(
                f"Wait for service timed out waiting for parameter services for node {self.name}"
            )
        return future.result()

    def _ask(self, kind: Any, service: str, request: dict[str, Any]) -> Future:
        client = self._node.create_client(kind, f"{self.name}/{service}", qos_profile=qos_profile_parameters)
        self._wait_for(client)
        return client.call_async(kind.Request(**request))

    def _wait_for(self, client: Any) -> None:
        """Until its service is there, or the whole graph and the node not in it."""
        start = time.monotonic()
        known = discover(handle_of(self._node), self._patience, enough=client.service_is_ready)
        if client.service_is_ready():
            return
        if self.name not in known.nodes:
            raise CommandError("Node not found")
        if not wait_until(client.service_is_ready, self._timeout - (time.monotonic() - start)):
            raise CommandError(
                f"Wait for service timed out waiting for parameter services for node {self.name}"
            )
