"""A rover at its base: five nodes offer services, one is stuck, and one calls a service that is missing."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib import import_module
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rclpy.node import Node

Answer = Callable[[Any, Any], Any]

TRIGGER = "std_srvs/srv/Trigger"
SET_BOOL = "std_srvs/srv/SetBool"
POINT = "package_with_interfaces/srv/WhatIsThePoint"
STAFF = "arm battery camera driver gripper localizer planner speaker".split()
ROOMS = "base front deck left mast rear right roof tail trailer".split()
TYPED = (
    ("maps", "nav_msgs/srv/LoadMap"),
    ("self_check", "diagnostic_msgs/srv/AddDiagnostics"),
    ("camera", "sensor_msgs/srv/SetCameraInfo"),
    ("state", "lifecycle_msgs/srv/ChangeState"),
    ("mode", "lifecycle_msgs/srv/GetState"),
)
WITH_FIELDS = (
    ("way", "nav_msgs/srv/GetPlan"),
    ("ground", "nav_msgs/srv/SetMap"),
    ("dictionary", "type_description_interfaces/srv/GetTypeDescription"),
)
# Only these services have the type `std_srvs/srv/Trigger`.
CHORES = "brake calibrate charge clean honk reset".split()
WORDS = "antenna axle bumper compass fender headlight magnet pulley spring wheel".split()


@dataclass(frozen=True)
class Plan:
    """What differs from rover to rover. `owners`: the node of each service. Node names have no slash.

    `point`: the oracle's answer if the quote's id is 0. If the id grows by 1, x grows by `step`.
    """

    typed: str
    type: str
    fields: str
    fields_type: str
    oracle: str
    point: tuple[float, float, float]
    step: float
    bell: str
    word: str
    other_word: str
    chores: tuple[str, str, str]
    silent: str
    sleeper: str
    wanted: str
    caller: str
    owners: Mapping[str, str]

    def x(self, number: int) -> float:
        """The x that the oracle returns for the id `number`."""
        return self.point[0] + self.step * number


def draw(seed: int) -> Plan:
    chance = random.Random(seed)
    staff, rooms = chance.sample(STAFF, 5), chance.sample(ROOMS, len(ROOMS))
    thing, type_name = chance.choice(TYPED)
    other_thing, fields_type = chance.choice(WITH_FIELDS)
    chores = [f"/{room}/{chore}" for room, chore in zip(rooms, chance.sample(CHORES, 4), strict=False)]
    word, other_word = chance.sample(WORDS, 2)
    typed, fields = f"/{rooms[4]}/{thing}", f"/{rooms[5]}/{other_thing}"
    oracle, bell = f"/{rooms[6]}/{chance.choice(('oracle', 'adviser'))}", f"/{rooms[7]}/bell"
    return Plan(
        typed=typed,
        type=type_name,
        fields=fields,
        fields_type=fields_type,
        oracle=oracle,
        point=_point(chance),
        step=chance.choice((0.25, 0.5, 0.75, 1.25)),
        bell=bell,
        word=word,
        other_word=other_word,
        chores=(chores[0], chores[1], chores[2]),
        silent=chores[3],
        sleeper=staff[4],
        wanted=f"/{rooms[8]}/{chance.choice(('winch', 'drone', 'elevator'))}",
        caller=staff[chance.randrange(4)],
        owners=_dealt([typed, fields, oracle, bell, *chores[:3]], staff[:4], chance),
    )


def _point(chance: random.Random) -> tuple[float, float, float]:
    """Three numbers far enough from each other and from the oracle's answers to all other ids."""
    x, y, z = chance.sample(range(10, 40), 3)
    return float(x), -float(y), -100.0 - z


def _dealt(services: list[str], nodes: list[str], chance: random.Random) -> Mapping[str, str]:
    shuffled = chance.sample(services, len(services))
    return MappingProxyType({name: nodes[n % len(nodes)] for n, name in enumerate(shuffled)})


def play(plan: Plan, acts: Any) -> list[Node]:
    from rclpy.node import Node

    nodes = {name: Node(name) for name in sorted(set(plan.owners.values()))}
    for service, (type_name, answer) in _answers(plan).items():
        nodes[plan.owners[service]].create_service(_type(type_name), service, answer)
    nodes[plan.caller].create_client(_type(SET_BOOL), plan.wanted)
    sleeper = Node(plan.sleeper)
    sleeper.create_service(_type(TRIGGER), plan.silent, _as_it_is)
    acts.idle(sleeper)
    return list(nodes.values())


def _answers(plan: Plan) -> dict[str, tuple[str, Answer]]:
    """For each service: its type, and the function that answers it."""
    return {
        plan.typed: (plan.type, _as_it_is),
        plan.fields: (plan.fields_type, _as_it_is),
        plan.oracle: (POINT, lambda request, response: _tell(plan, request, response)),
        plan.bell: (SET_BOOL, lambda request, response: _ring(plan, request, response)),
        **{chore: (TRIGGER, _done) for chore in plan.chores},
    }


def _type(name: str) -> Any:
    package, _, short = name.split("/")
    return getattr(import_module(f"{package}.srv"), short)


def _tell(plan: Plan, request: Any, response: Any) -> Any:
    response.point.x = plan.x(request.quote.id)
    response.point.y, response.point.z = plan.point[1:]
    return response


def _ring(plan: Plan, request: Any, response: Any) -> Any:
    response.success = True
    response.message = plan.word if request.data else plan.other_word
    return response


def _done(_request: Any, response: Any) -> Any:
    response.success = True
    response.message = "At once"
    return response


def _as_it_is(_request: Any, response: Any) -> Any:
    return response
