"""A rover at work: nine nodes use topics; two miss each other by a letter, and one waits for a quote."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from itertools import cycle
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rclpy.node import Node

WANTED_ID = 1994
ACKNOWLEDGED = "/acknowledged"
QUOTE_TYPE = "package_with_interfaces/msg/AmazingQuote"
QUOTE_PERIOD = 0.25
SLOW = 1.0

CREW = "arm battery camera driver localizer mapper navigator planner recorder scanner speaker radio".split()
PLACES = "arm base front left mast rear right roof".split()
# What is measured, its type, and the field that contains the number.
MEASURED = (
    ("air", "sensor_msgs/msg/RelativeHumidity", "relative_humidity"),
    ("motor", "sensor_msgs/msg/Temperature", "temperature"),
    ("obstacle", "sensor_msgs/msg/Range", "range"),
    ("daylight", "sensor_msgs/msg/Illuminance", "illuminance"),
    ("tire", "sensor_msgs/msg/FluidPressure", "fluid_pressure"),
    ("drift", "geometry_msgs/msg/Vector3", "x"),
)
MISSPELT = ("compass", "odometer", "voltage", "steering", "tachometer", "distance")
RATES = (2.0, 3.0, 5.0, 8.0, 12.0)
PASSWORDS = "marmalade pumpernickel rhubarb saffron turnip walnut cinnamon gooseberry".split()
THINKERS = (
    "Aunt Axle",
    "Captain Gearbox",
    "Doctor Drizzle",
    "Grandfather Gravel",
    "Lady Lidar",
    "Madam Magnet",
    "Old Odometer",
    "Professor Pebble",
    "Sister Solder",
    "Uncle Torque",
)
THOUGHTS = (
    "A smooth road teaches nobody to steer, but it is nicer.",
    "If you coil the cable today, you will find it tomorrow.",
    "The horizon is always on time.",
    "Two maps are one decision too many.",
    "A full battery has no enemies.",
    "Ask the wheel once, and the ground twice.",
    "Every map was blank, and then somebody got lost.",
    "A robot that counts stones never runs out of work.",
)


@dataclass(frozen=True)
class Said:
    """One of the quotes that repeat."""

    id: int
    quote: str
    philosopher: str


@dataclass(frozen=True)
class Plan:
    """What differs from rover to rover. `rate`: of `measured`, in hertz. Node names have no slash."""

    measured: str
    type: str
    field: str
    rate: float
    measurer: str
    reader: str
    shared: str
    sharers: tuple[str, str]
    said: str
    heard: str
    sayer: str
    hearer: str
    notice: str
    notifier: str
    password: str
    quotes: str
    reciter: str
    recited: tuple[Said, ...]
    asked: Said
    waiting: str
    waiter: str


def draw(seed: int) -> Plan:
    chance = random.Random(seed)
    crew, places = chance.sample(CREW, len(CREW)), chance.sample(PLACES, len(PLACES))
    thing, type_name, field = chance.choice(MEASURED)
    right = chance.choice(MISSPELT)
    names = [right, slip(right, chance)]
    chance.shuffle(names)
    recited = _recited(chance)
    return Plan(
        measured=f"/{places[0]}/{thing}",
        type=type_name,
        field=field,
        rate=chance.choice(RATES),
        measurer=crew[0],
        reader=crew[1],
        shared=f"/{places[1]}/{chance.choice(('horn', 'siren', 'chime'))}",
        sharers=(crew[2], crew[3]),
        said=f"/{places[2]}/{names[0]}",
        heard=f"/{places[2]}/{names[1]}",
        sayer=crew[4],
        hearer=crew[5],
        notice=f"/{places[3]}/{chance.choice(('notice', 'mission', 'logbook'))}",
        notifier=crew[6],
        password=chance.choice(PASSWORDS),
        quotes=f"/{places[4]}/{chance.choice(('wisdom', 'small_talk', 'stories'))}",
        reciter=crew[7],
        recited=recited,
        asked=chance.choice(recited),
        waiting=f"/{places[5]}/{chance.choice(('inbox', 'orders', 'requests'))}",
        waiter=crew[8],
    )


def slip(word: str, chance: random.Random) -> str:
    """The word with one letter missing or two neighbors swapped, but never the word itself."""
    places = [n for n in range(1, len(word) - 2) if word[n] != word[n + 1]]
    at = chance.choice(places)
    if chance.random() < 0.5:
        return word[:at] + word[at + 1 :]
    return word[:at] + word[at + 1] + word[at] + word[at + 2 :]


def _recited(chance: random.Random) -> tuple[Said, ...]:
    ids = chance.sample(range(100, 1000), len(THOUGHTS))
    thoughts, thinkers = chance.sample(THOUGHTS, len(THOUGHTS)), chance.sample(THINKERS, len(THOUGHTS))
    return tuple(map(Said, ids, thoughts, thinkers))


def play(plan: Plan, acts: Any) -> list[Node]:
    talking = [*_instruments(plan), *_sharers(plan), *_strangers(plan)]
    return [*talking, _notifier(plan), _reciter(plan), _waiter(plan, acts)]


def _type(name: str) -> Any:
    package, _, short = name.split("/")
    return getattr(import_module(f"{package}.msg"), short)


def _repeat(node: Node, period: float, topic: str, make: Callable[[], Any]) -> None:
    """Publish what `make` returns, again and again."""
    publisher = node.create_publisher(type(make()), topic, 10)
    node.create_timer(period, lambda: publisher.publish(make()))


def _instruments(plan: Plan) -> list[Node]:
    """One node that measures, and one that reads the measurements."""
    from rclpy.node import Node

    measurer, reader = Node(plan.measurer), Node(plan.reader)
    kind, values = _type(plan.type), cycle((0.25, 0.5, 0.75, 0.5))
    _repeat(measurer, 1 / plan.rate, plan.measured, lambda: kind(**{plan.field: next(values)}))
    reader.create_subscription(kind, plan.measured, _ignored, 10)
    return [measurer, reader]


def _sharers(plan: Plan) -> list[Node]:
    """Two nodes that publish on the same topic."""
    from rclpy.node import Node
    from std_msgs.msg import Bool

    nodes = [Node(name) for name in plan.sharers]
    for node in nodes:
        _repeat(node, SLOW, plan.shared, lambda: Bool(data=True))
    return nodes


def _strangers(plan: Plan) -> list[Node]:
    """Two nodes whose topics differ by a letter or two, so they never connect."""
    from rclpy.node import Node
    from std_msgs.msg import Float64

    sayer, hearer = Node(plan.sayer), Node(plan.hearer)
    _repeat(sayer, SLOW, plan.said, lambda: Float64(data=4.5))
    hearer.create_subscription(Float64, plan.heard, _ignored, 10)
    return [sayer, hearer]


def _notifier(plan: Plan) -> Node:
    """A node that publishes once, before anyone can listen, and keeps the message for late subscribers."""
    from rclpy.node import Node
    from rclpy.qos import DurabilityPolicy, QoSProfile
    from std_msgs.msg import String

    node = Node(plan.notifier)
    kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    publisher = node.create_publisher(String, plan.notice, kept)
    publisher.publish(String(data=f"Today's password is {plan.password}"))
    return node


def _reciter(plan: Plan) -> Node:
    from package_with_interfaces.msg import AmazingQuote
    from rclpy.node import Node

    node, turns = Node(plan.reciter), cycle(plan.recited)

    def recite() -> AmazingQuote:
        said = next(turns)
        return AmazingQuote(id=said.id, quote=said.quote, philosopher_name=said.philosopher)

    _repeat(node, QUOTE_PERIOD, plan.quotes, recite)
    return node


def _waiter(plan: Plan, acts: Any) -> Node:
    """A node that waits for one quote and replies to each one that arrives."""
    from package_with_interfaces.msg import AmazingQuote
    from rclpy.node import Node
    from std_msgs.msg import String

    node = Node(plan.waiter)
    answer = node.create_publisher(String, ACKNOWLEDGED, 10)

    def hear(message: AmazingQuote) -> None:
        if message.id == WANTED_ID:
            answer.publish(String(data=f"That is number {WANTED_ID}, at last. Thank you!"))
            acts.record("published")
        else:
            answer.publish(String(data=f"Number {message.id} is not the one I am waiting for."))
            acts.record("other_id", str(message.id))

    node.create_subscription(AmazingQuote, plan.waiting, hear, 10)
    return node


def _ignored(_message: Any) -> None:
    pass
