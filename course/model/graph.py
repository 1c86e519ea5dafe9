"""The ROS graph at one moment: nodes, endpoints of topics with their QoS, services."""

from __future__ import annotations

from math import inf
from typing import Literal

from msgspec import Struct

Kind = Literal["publisher", "subscription"]


class Qos(Struct, frozen=True, order=True, forbid_unknown_fields=True):
    """The QoS policies that decide whether two endpoints match, with their ROS values.

    deadline: seconds; 0 if there is none, as in ROS.
    """

    reliability: str = "reliable"
    durability: str = "volatile"
    liveliness: str = "automatic"
    deadline: float = 0.0


class Endpoint(Struct, frozen=True, order=True, forbid_unknown_fields=True):
    """One publisher or subscription.

    node: full name such as "/talker"; "" until discovery knows it. type_hash: RIHS01 hash of the type that
    the process which owns the endpoint was built with.
    """

    topic: str
    kind: Kind
    node: str
    type: str
    type_hash: str
    qos: Qos


class Service(Struct, frozen=True, order=True, forbid_unknown_fields=True):
    """A service by name and type.

    request_hash, response_hash: RIHS01 hashes that the server was built with; "" without a server. servers,
    clients: full names of the nodes that offer and use it, if known.
    """

    name: str
    type: str
    request_hash: str = ""
    response_hash: str = ""
    servers: tuple[str, ...] = ()
    clients: tuple[str, ...] = ()


class Graph(Struct, frozen=True, forbid_unknown_fields=True):
    """The nodes, endpoints and services present. Names are full (`/chatter`); everything is sorted."""

    nodes: tuple[str, ...] = ()
    endpoints: tuple[Endpoint, ...] = ()
    services: tuple[Service, ...] = ()

    def publishers(self, topic: str) -> tuple[Endpoint, ...]:
        """Return the publishers on `topic` (full name)."""
        return tuple(e for e in self.endpoints if e.topic == topic and e.kind == "publisher")

    def subscriptions(self, topic: str) -> tuple[Endpoint, ...]:
        """Return the subscriptions on `topic` (full name)."""
        return tuple(e for e in self.endpoints if e.topic == topic and e.kind == "subscription")

    def topics_of(self, kind: Kind) -> tuple[str, ...]:
        """Return the names of topics that have such an endpoint, except for ROS's own topics."""
        return tuple(
            sorted({e.topic for e in self.endpoints if e.kind == kind and not infrastructure(e.topic)})
        )


def infrastructure(topic: str) -> bool:
    """Whether ROS itself creates this topic in every node."""
    return topic in ("/rosout", "/parameter_events")


def mismatch(publisher: Qos, subscription: Qos) -> str | None:
    """The policy that keeps these two from matching ("reliability", "durability", ...), or None.

    A subscription may not ask for more than the publisher offers. Source: ROS 2 documentation, "Quality of
    Service settings", compatibility tables.
    """
    if subscription.reliability == "reliable" and publisher.reliability == "best_effort":
        return "reliability"
    if subscription.durability == "transient_local" and publisher.durability == "volatile":
        return "durability"
    if subscription.liveliness == "manual_by_topic" and publisher.liveliness != "manual_by_topic":
        return "liveliness"
    return "deadline" if (subscription.deadline or inf) < (publisher.deadline or inf) else None
