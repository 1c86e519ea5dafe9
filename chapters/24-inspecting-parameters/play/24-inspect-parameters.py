"""A rover that publishes quotes and has extra parameters. Learners can't set one of them."""

from __future__ import annotations

import random
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import yaml

if TYPE_CHECKING:
    from rclpy.node import Node

NODE = "peanut_butter_falcon_quote_publisher_node"
TOPIC = "truly_inspirational_quote"
EVENTS = "/parameter_events"
# The file that learners load.
GIVEN = "starter/24-inspect-parameters/ros2_tutorial_workspace/src/quote_of_the_day.yaml"
TEXTS = ("quote", "philosopher_name")

PERIODS = (0.2, 0.25, 0.4, 0.8, 1.6)
DIALS = "brightness loudness patience range speed".split()
# Some values do not look like their type.
ODD_ONES = (
    ("license", "string", "2027"),
    ("serial_number", "string", "17.5"),
    ("awake", "string", "true"),
    ("wheelbase", "double", 1.0),
    ("weight", "double", 2.0),
    ("tracked", "boolean", True),
    ("covered", "boolean", False),
    ("friends", "string array", ["camera", "arm"]),
)
FIXED = (("built_in", "a garage"), ("built_from", "a kit"), ("first_owner", "a mail carrier"))
THINKERS = (
    "A Patient Mechanic",
    "Cousin Thistle",
    "Lady Thunderclap",
    "Madam Windmill",
    "The Old Postman",
    "Uncle Rainbarrel",
)
THOUGHTS = (
    "Look first, then ask how far it is.",
    "A screw is a very small plan.",
    "Look back only to see how far you have come.",
    "The ground has no opinion of you.",
    "Tape holds more together than glue.",
)


@dataclass(frozen=True)
class Plan:
    """What differs from rover to rover. `dial`, `odd`, `fixed`: names of parameters. `period`: in seconds.

    `given`: the quote and the philosopher in the file to load. They are the same for everyone.
    """

    quote: str
    philosopher: str
    period: float
    dial: str
    low: int
    high: int
    set_to: int
    odd: str
    odd_type: str
    odd_value: Any
    fixed: str
    fixed_value: str
    given: tuple[str, ...]


def draw(seed: int) -> Plan:
    chance = random.Random(seed)
    low, high = chance.randrange(2, 9), chance.randrange(60, 500)
    odd, odd_type, odd_value = chance.choice(ODD_ONES)
    fixed, fixed_value = chance.choice(FIXED)
    return Plan(
        quote=chance.choice(THOUGHTS),
        philosopher=chance.choice(THINKERS),
        period=chance.choice(PERIODS),
        dial=chance.choice(DIALS),
        low=low,
        high=high,
        set_to=chance.randrange(15, 50),
        odd=odd,
        odd_type=odd_type,
        odd_value=odd_value,
        fixed=fixed,
        fixed_value=fixed_value,
        given=_given(),
    )


def _given() -> tuple[str, ...]:
    file = Path(__file__).parents[1] / GIVEN
    values = yaml.safe_load(file.read_text(encoding="utf-8"))[f"/{NODE}"]["ros__parameters"]
    return tuple(values[name] for name in TEXTS)


def play(plan: Plan, acts: Any) -> list[Node]:
    from rclpy.node import Node

    node = Node(NODE)
    _declare(node, plan)
    _publish(node, plan)
    _watch(node, plan, acts)
    return [node]


def _declare(node: Node, plan: Plan) -> None:
    from rcl_interfaces.msg import IntegerRange, ParameterDescriptor

    node.declare_parameter("quote", plan.quote)
    node.declare_parameter("philosopher_name", plan.philosopher)
    node.declare_parameter("topic_name", TOPIC)
    node.declare_parameter("period", plan.period)
    node.declare_parameter(plan.odd, plan.odd_value)
    limits = IntegerRange(from_value=plan.low, to_value=plan.high, step=1)
    node.declare_parameter(plan.dial, plan.set_to, ParameterDescriptor(integer_range=[limits]))
    node.declare_parameter(plan.fixed, plan.fixed_value, ParameterDescriptor(read_only=True))


def _publish(node: Node, plan: Plan) -> None:
    """Like the node from chapter 22: read the topic and the period once, and the text for each message."""
    from package_with_interfaces.msg import AmazingQuote

    publisher = node.create_publisher(AmazingQuote, TOPIC, 10)

    def say() -> None:
        quote, philosopher = (node.get_parameter(name).value for name in TEXTS)
        publisher.publish(AmazingQuote(quote=quote, philosopher_name=philosopher))

    node.create_timer(plan.period, say)


def _watch(node: Node, plan: Plan, acts: Any) -> None:
    """Record what is set, as anyone can hear on /parameter_events."""
    from rcl_interfaces.msg import ParameterEvent

    def hear(event: ParameterEvent) -> None:
        if event.node != f"/{NODE}":
            return
        for changed in event.changed_parameters:
            if changed.name == plan.dial:
                _record_dial(plan, acts, changed.value.integer_value)
            elif changed.name == "quote" and changed.value.string_value != plan.given[0]:
                acts.record("other_quote", changed.value.string_value)
        if tuple(node.get_parameter(name).value for name in TEXTS) == plan.given:
            acts.record("loaded")

    node.create_subscription(ParameterEvent, EVENTS, hear, 10)


def _record_dial(plan: Plan, acts: Any, value: int) -> None:
    if value == plan.high:
        acts.record("set")
    else:
        acts.record("set_other", str(value))
