"""The ROS graph at one moment: nodes, endpoints of topics with their QoS, services."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import Literal

Kind = Literal["publisher", "subscription"]


@dataclass(frozen=True, order=True)
class Qos:
    """The QoS policies that decide whether two endpoints match, by their ROS names.

    deadline: seconds; infinite when there is none.
    """

    reliability: str = "reliable"
    durability: str = "volatile"
    liveliness: str = "automatic"
    deadline: float = inf


@dataclass(frozen=True, order=True)
class Endpoint:
    """One publisher or subscription.

    node: full name such as "/talker", "" while discovery does not know it yet.
    type_hash: RIHS01 hash of the type as the process that owns it was built with.
    """

    topic: str
    kind: Kind
    node: str
    type: str
    type_hash: str
    qos: Qos


@dataclass(frozen=True, order=True)
class Service:
    """A service by name and type.

    request_hash, response_hash: RIHS01 hashes as the server was built; "" without a server.
    servers, clients: full names of the nodes that offer and use it, as far as they are known.
    """

    name: str
    type: str
    request_hash: str = ""
    response_hash: str = ""
    servers: tuple[str, ...] = ()
    clients: tuple[str, ...] = ()


@dataclass(frozen=True)
class Graph:
    """Who was there. Names are full (`/chatter`); everything is sorted."""

    nodes: tuple[str, ...] = ()
    endpoints: tuple[Endpoint, ...] = ()
    services: tuple[Service, ...] = ()

    def publishers(self, topic: str) -> tuple[Endpoint, ...]:
        return tuple(e for e in self.endpoints if e.topic == topic and e.kind == "publisher")

    def subscriptions(self, topic: str) -> tuple[Endpoint, ...]:
        return tuple(e for e in self.endpoints if e.topic == topic and e.kind == "subscription")

    def topics_of(self, kind: Kind) -> tuple[str, ...]:
        """Names of the topics that have an endpoint of this kind, without ROS's own."""
        return tuple(
            sorted({e.topic for e in self.endpoints if e.kind == kind and not infrastructure(e.topic)})
        )


def infrastructure(topic: str) -> bool:
    """Whether ROS itself makes this topic in every node."""
    return topic in ("/rosout", "/parameter_events")


def mismatch(publisher: Qos, subscription: Qos) -> str | None:
    """The policy that keeps these two apart ("reliability", "durability", ...), or None.

    A subscription may ask for no more than the publisher offers.
    Source: ROS 2 documentation, "Quality of Service settings", compatibility tables.
    """
    if subscription.reliability == "reliable" and publisher.reliability == "best_effort":
        return "reliability"
    if subscription.durability == "transient_local" and publisher.durability == "volatile":
        return "durability"
    if subscription.liveliness == "manual_by_topic" and publisher.liveliness != "manual_by_topic":
        return "liveliness"
    return "deadline" if subscription.deadline < publisher.deadline else None
