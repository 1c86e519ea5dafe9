"""The graph as read from a node; the node is a fake."""

from __future__ import annotations

from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import Any

import pytest

from course.evidence.graph_reader import GraphReader, full_name
from course.model.graph import Endpoint, Qos, Service

STRING = "std_msgs/msg/String"
ADD = "example_interfaces/srv/AddTwoInts"
FOR_EVER = 9223372036854775807
UNKNOWN = "_NODE_NAME_UNKNOWN_"


def info(
    node: str,
    reliability: str = "RELIABLE",
    deadline: int = FOR_EVER,
    namespace: str = "/",
    type_name: str = STRING,
) -> Any:
    def policy(name: str) -> SimpleNamespace:
        return SimpleNamespace(name=name)

    profile = SimpleNamespace(
        reliability=policy(reliability),
        durability=policy("VOLATILE"),
        liveliness=policy("AUTOMATIC"),
        deadline=SimpleNamespace(nanoseconds=deadline),
    )
    return SimpleNamespace(
        node_name=node,
        node_namespace=namespace,
        topic_type=type_name,
        topic_type_hash="RIHS01_1",
        qos_profile=profile,
    )


@dataclass
class World:
    """Answers like an rclpy node; `reads` counts the expensive questions."""

    nodes: list[tuple[str, str]] = field(default_factory=lambda: [("recorder", "/")])
    publishers: dict[str, list[Any]] = field(default_factory=dict)
    subscriptions: dict[str, list[Any]] = field(default_factory=dict)
    services: list[tuple[str, list[str]]] = field(default_factory=list)
    reads: int = 0

    def get_fully_qualified_name(self) -> str:
        return "/recorder"

    def get_node_names_and_namespaces(self) -> list[tuple[str, str]]:
        return list(self.nodes)

    def get_topic_names_and_types(self) -> list[tuple[str, list[str]]]:
        return [
            (name, [STRING]) for name in sorted({*self.publishers, *self.subscriptions}) if name[0] == "/"
        ]

    def count_publishers(self, topic: str) -> int:
        return len(self.publishers.get(topic, []))

    def count_subscribers(self, topic: str) -> int:
        return len(self.subscriptions.get(topic, []))

    def get_publishers_info_by_topic(self, topic: str, no_mangle: bool = False) -> list[Any]:
        self.reads += 1
        return self.publishers.get(topic, [])

    def get_subscriptions_info_by_topic(self, topic: str, no_mangle: bool = False) -> list[Any]:
        return self.subscriptions.get(topic, [])

    def count_services(self, service: str) -> int:
        return len(self.subscriptions.get(f"rq{service}Request", []))

    def count_clients(self, service: str) -> int:
        return len(self.publishers.get(f"rq{service}Request", []))

    def get_service_names_and_types(self) -> list[tuple[str, list[str]]]:
        return list(self.services)


def test_the_reading_node_is_left_out() -> None:
    world = World(nodes=[("recorder", "/"), ("talker", "/robot")])
    world.publishers["/talk"] = [info("recorder"), info("talker", namespace="/robot")]
    graph = GraphReader(world).read_if_changed()
    assert graph.nodes == ("/robot/talker",)
    assert graph.endpoints == (Endpoint("/talk", "publisher", "/robot/talker", STRING, "RIHS01_1", Qos()),)


def test_nothing_is_read_again_while_nothing_changes() -> None:
    world = World(publishers={"/talk": [info("talker")]})
    reader = GraphReader(world)
    assert reader.read_if_changed() is not None
    reads = world.reads
    assert reader.read_if_changed() is None
    assert world.reads == reads


@pytest.mark.parametrize("change", ["node", "publisher", "subscription", "topic", "service"])
def test_a_change_is_seen(change: str) -> None:
    world = World(publishers={"/talk": [info("talker")]})
    reader = GraphReader(world)
    reader.read_if_changed()
    if change == "node":
        world.nodes.append(("listener", "/"))
    elif change == "publisher":
        world.publishers["/talk"].append(info("talker"))
    elif change == "service":
        world.services.append(("/add", ["example_interfaces/srv/AddTwoInts"]))
    else:
        world.subscriptions["/talk" if change == "subscription" else "/other"] = [info("listener")]
    assert reader.read_if_changed() is not None
    assert reader.read_if_changed() is None


def test_it_looks_again_until_all_nodes_have_names() -> None:
    world = World(publishers={"/talk": [info(UNKNOWN)]})
    reader = GraphReader(world)
    graph = reader.read_if_changed()
    assert [endpoint.node for endpoint in graph.endpoints] == [""]
    world.publishers["/talk"] = [info("talker")]
    graph = reader.read_if_changed()
    assert [endpoint.node for endpoint in graph.endpoints] == ["/talker"]
    assert reader.read_if_changed() is None


@pytest.mark.parametrize(
    ("nanoseconds", "seconds"),
    [(FOR_EVER, 0.0), (0, 0.0), (500_000_000, 0.5), (9_223_372_036_000_000_000, 0.0)],
)
def test_qos(nanoseconds: int, seconds: float) -> None:
    world = World(subscriptions={"/talk": [info("listener", "BEST_EFFORT", nanoseconds)]})
    graph = GraphReader(world).read_if_changed()
    assert graph.subscriptions("/talk")[0].qos == Qos("best_effort", "volatile", "automatic", seconds)


def test_services_with_the_hashes_of_their_server() -> None:
    world = World(
        services=[
            ("/talker/get_parameters", ["rcl_interfaces/srv/GetParameters"]),
            ("/talker/get_type_description", ["type_description_interfaces/srv/GetTypeDescription"]),
            ("/add", ["example_interfaces/srv/AddTwoInts"]),
            ("/client_only", ["example_interfaces/srv/AddTwoInts"]),
        ]
    )
    world.subscriptions["rq/addRequest"] = [info("adder")]
    world.publishers["rr/addReply"] = [info("adder")]
    graph = GraphReader(world).read_if_changed()
    assert graph.services == (
        Service("/add", ADD, "RIHS01_1", "RIHS01_1", ("/adder",)),
        Service("/client_only", "example_interfaces/srv/AddTwoInts"),
    )


@pytest.mark.parametrize("first", ["rq/addRequest", "rr/addReply"])
def test_a_server_is_known_by_both_hashes_or_none(first: str) -> None:
    """Its two topics are discovered one after the other."""
    world = World(services=[("/add", [ADD])])
    reader = GraphReader(world)
    ends = {"rq/addRequest": world.subscriptions, "rr/addReply": world.publishers}
    ends[first][first] = [info("adder")]
    graph = reader.read_if_changed()
    assert [(s.request_hash, s.response_hash) for s in graph.services] == [("", "")]
    for name, end in ends.items():
        end[name] = [info("adder")]
    graph = reader.read_if_changed()
    assert graph.services == (Service("/add", ADD, "RIHS01_1", "RIHS01_1", ("/adder",)),)
    assert reader.read_if_changed() is None


def test_a_server_that_comes_after_its_client_is_seen() -> None:
    world = World(services=[("/add", [ADD])])
    reader = GraphReader(world)
    reader.read_if_changed()
    world.subscriptions["rq/addRequest"] = world.publishers["rr/addReply"] = [info("adder")]
    graph = reader.read_if_changed()
    assert graph.services == (Service("/add", ADD, "RIHS01_1", "RIHS01_1", ("/adder",)),)


def test_servers_and_clients_by_their_nodes() -> None:
    world = World(services=[("/add", [ADD])])
    world.subscriptions["rq/addRequest"] = world.publishers["rr/addReply"] = [info("adder"), info("other")]
    world.publishers["rq/addRequest"] = [info("asker", namespace="/robot"), info("recorder")]
    graph = GraphReader(world).read_if_changed()
    (service,) = graph.services
    assert (service.servers, service.clients) == (("/adder", "/other"), ("/robot/asker",))


def test_a_client_that_comes_later_is_seen() -> None:
    world = World(services=[("/add", [ADD])])
    reader = GraphReader(world)
    reader.read_if_changed()
    world.publishers["rq/addRequest"] = [info("asker")]
    graph = reader.read_if_changed()
    assert graph.services[0].clients == ("/asker",)


def test_it_looks_again_until_a_client_has_a_name() -> None:
    world = World(services=[("/add", [ADD])])
    world.publishers["rq/addRequest"] = [info(UNKNOWN)]
    reader = GraphReader(world)
    reader.read_if_changed()
    world.publishers["rq/addRequest"] = [info("asker")]
    graph = reader.read_if_changed()
    assert graph.services[0].clients == ("/asker",)
    assert reader.read_if_changed() is None


@pytest.mark.parametrize("end", ["server", "client"])
def test_services_that_only_the_reading_node_knows_are_left_out(end: str) -> None:
    world = World(services=[("/add", [ADD])])
    if end == "client":
        world.publishers["rq/addRequest"] = [info("recorder")]
    else:
        world.subscriptions["rq/addRequest"] = world.publishers["rr/addReply"] = [info("recorder")]
    graph = GraphReader(world).read_if_changed()
    assert graph.services == ()


def test_two_types_on_one_name_are_kept_apart() -> None:
    """The reading node's own client has the right type, the server another one."""
    set_bool, trigger = "std_srvs::srv::dds_::SetBool_{}_", "std_srvs::srv::dds_::Trigger_{}_"
    world = World(services=[("/x", ["std_srvs/srv/SetBool", "std_srvs/srv/Trigger"])])
    world.publishers["rq/xRequest"] = [info("recorder", type_name=set_bool.format("Request"))]
    world.subscriptions["rq/xRequest"] = [info("server", type_name=trigger.format("Request"))]
    world.publishers["rr/xReply"] = [info("server", type_name=trigger.format("Response"))]
    graph = GraphReader(world).read_if_changed()
    assert graph.services == (Service("/x", "std_srvs/srv/Trigger", "RIHS01_1", "RIHS01_1", ("/server",)),)


@pytest.mark.parametrize(
    ("name", "namespace", "full"),
    [("talker", "/", "/talker"), ("talker", "/robot", "/robot/talker"), ("talker", "", "/talker")],
)
def test_full_names(name: str, namespace: str, full: str) -> None:
    assert full_name(name, namespace) == full
