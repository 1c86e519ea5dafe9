"""What the verbs of `ros2 component` have in common: what is registered, and asking containers."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from typing import Any

from ament_index_python import get_resource, get_resources, has_resource

from ros2cli.arguments import add_completed
from ros2cli.errors import CommandError
from ros2cli.graph import graph
from ros2cli.snapshot import Snapshot

_INDEX = "rclcpp_components"
_TIMEOUT = 5.0
_SERVICES = {"load_node": "LoadNode", "unload_node": "UnloadNode", "list_nodes": "ListNodes"}


def types_of(package: str) -> list[str]:
    """The classes that the package registers."""
    if not has_resource(_INDEX, package):
        return []
    content, _ = get_resource(_INDEX, package)
    return [line.partition(";")[0] for line in content.splitlines() if line]


def packages_with_types(prefix: str = "", parsed_args: Any = None, **_: Any) -> list[str]:
    """Those that register a class; also completes them."""
    return list(get_resources(_INDEX))


def containers(known: Snapshot) -> list[str]:
    """The nodes that offer all services of a container."""
    services = known.services(hidden=True)
    return [
        node
        for node in dict.fromkeys(known.nodes)
        if all(
            f"composition_interfaces/srv/{kind}" in services.get(f"{node}/_container/{name}", ())
            for name, kind in _SERVICES.items()
        )
    ]


def container_names(prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
    return containers(graph(parsed_args))


def add_container_argument(parser: ArgumentParser, **options: Any) -> None:
    add_completed(parser, "container_node_name", container_names, **options)


def asked_container(args: Namespace) -> str:
    """The container of the command line; CommandError when there is none of this name."""
    if args.container_node_name not in containers(graph(args)):
        raise CommandError(f"Unable to find container node '{args.container_node_name}'")
    return str(args.container_node_name)


def add_component_arguments(parser: ArgumentParser) -> None:
    text = "Name of the package where the component is to be found"
    add_completed(parser, "package_name", packages_with_types, help=text)
    add_completed(parser, "plugin_name", _types, help="Type name of the component to be loaded")
    add = parser.add_argument
    add("-n", "--node-name", default="", help="Component node name")
    add("--node-namespace", default="", help="Component node namespace")
    add("--log-level", type=int, default=0, help="Component node log level")
    text = "Component node remapping rules, in the 'from:=to' form"
    add("-r", "--remap-rule", action="append", default=[], dest="remap_rules", help=text)
    text = "Component node parameters, in the 'name:=value' form"
    add("-p", "--parameter", action="append", default=[], dest="parameters", help=text)
    text = "Extra arguments for the container, in the 'name:=value' form"
    add("-e", "--extra-argument", action="append", default=[], dest="extra_arguments", help=text)


def load(node: Any, container: str, args: Namespace) -> tuple[int, str]:
    """Load what `add_component_arguments` describe; its number and its name."""
    response = call(
        node,
        container,
        "load_node",
        package_name=args.package_name,
        plugin_name=args.plugin_name,
        node_name=args.node_name,
        node_namespace=args.node_namespace,
        log_level=args.log_level,
        remap_rules=args.remap_rules,
        parameters=_parameters(args.parameters),
        extra_arguments=_parameters(args.extra_arguments),
    )
    if not response.success:
        raise CommandError(f"Failed to load component: {response.error_message.capitalize()}")
    return response.unique_id, response.full_node_name


def loaded(node: Any, container: str) -> list[tuple[int, str]]:
    """Number and name of each component of the container."""
    response = call(node, container, "list_nodes")
    return list(zip(response.unique_ids, response.full_node_names, strict=True))


def call(node: Any, container: str, service: str, **request: Any) -> Any:
    """The response. CommandError without such a service; what loads may take as long as it wants."""
    import composition_interfaces.srv
    import rclpy

    from ros2cli.node import wait_until

    kind = getattr(composition_interfaces.srv, _SERVICES[service])
    client = node.create_client(kind, f"{container}/_container/{service}")
    if not wait_until(client.service_is_ready, _TIMEOUT):
        raise CommandError(f"No '{service}' service found for '{container}' container")
    future = client.call_async(kind.Request(**request))
    rclpy.spin_until_future_complete(node, future)
    return future.result()


def _types(prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
    return types_of(str(parsed_args.package_name))


def _parameters(given: Sequence[str]) -> list[Any]:
    from rcl_interfaces.msg import Parameter

    from ros2cli.param_values import guessed_value

    split = (text.partition(":=") for text in given)
    return [Parameter(name=name, value=guessed_value(value)) for name, _, value in split]
