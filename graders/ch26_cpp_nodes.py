"""Graders of chapter 26: a node in C++ that logs a count twice per second, and the rover's controller."""

from __future__ import annotations

import re
from math import inf

import pytest

from course.api import (
    Arena,
    Failure,
    Feedback,
    Grader,
    Location,
    LogLine,
    Recording,
    cause_of_silence,
    expect_clean_interrupt,
    expect_dependency,
    expect_endpoint,
    expect_logged,
    expect_node,
    expect_period,
    expect_qos,
    expect_running,
    expect_type,
    text_places,
)
from lib import rover
from lib.counts import await_counted, expect_counting
from lib.deliveries import first_reaction

PACKAGE = "cpp_package_with_a_node"
NODE = "print_forever_node"
NAME = "print_forever"
HEADERS = f"ros2_tutorial_workspace/src/{PACKAGE}/include/{PACKAGE}"
FIRST = "Printed 0 times."
LINE = re.compile(r"Printed (\d+) times\.")
ENOUGH = 5

cpp_node = Grader("26-cpp-node")


@cpp_node.scenario
def five_messages(arena: Arena) -> None:
    """Record five messages, to get four intervals."""
    node = arena.run(PACKAGE, NODE)
    await_counted(arena, node, "Print", ENOUGH, seconds=6)
    arena.interrupt(node)


def counted(recording: Recording) -> tuple[LogLine, ...]:
    return tuple(line for line in recording.log if LINE.search(line.text))


@cpp_node.check("starts", "the node starts and keeps running")
def starts(recording: Recording) -> None:
    expect_running(recording, NODE)


@cpp_node.check("node_name", "the node's name contains `print_forever`", needs="starts")
def node_name(recording: Recording) -> None:
    expect_node(recording, NAME, whole=False)


@cpp_node.check("logs", "it logs `Printed N times.` at level INFO", needs="starts")
def logs(recording: Recording) -> None:
    expect_logged(recording, NODE, counted(recording), FIRST, "Print")


@cpp_node.check("counts", "the count goes up by one, from 0", points=2, needs="logs")
def counts(recording: Recording) -> None:
    lines = counted(recording)
    expect_counting(
        lines,
        LINE,
        sources=recording.sources,
        terminal=recording.process(NODE).text,
        first=FIRST,
        begin="Start with `int count_ = 0;`. Log the message first, then add one to the count.",
        step="Keep the count in a member of the class. Add one each time: `count_++;`.",
    )
    if len(lines) < ENOUGH:
        raise Failure(too_few(recording, lines))


def too_few(recording: Recording, lines: tuple[LogLine, ...]) -> Feedback:
    look_at = "does a 0.5 s timer from `create_wall_timer` call the function that logs?"
    cause = cause_of_silence(recording, NODE, look_at=look_at)
    return Feedback(
        summary=f"The node logged only {len(lines)} time{'s' if len(lines) > 1 else ''}, "
        "but it should never stop.",
        expected="a message every 0.5 s",
        seen=f"{len(lines)} message{'s' if len(lines) > 1 else ''} in total",
        where=cause.where,
        advice=cause.text,
        details=tuple(line.text for line in lines[:3]),
    )


@cpp_node.check("rate", "it logs twice per second", points=2, needs="logs")
def rate(recording: Recording) -> None:
    times = tuple(line.t for line in counted(recording))
    if len(times) < ENOUGH:
        pytest.skip("there are too few messages to tell")
    expect_period(times, 0.5, what="log messages", program=recording)


@cpp_node.check("declares_rclcpp", "package.xml declares rclcpp")
def declares_rclcpp(recording: Recording) -> None:
    expect_dependency(recording, PACKAGE, "rclcpp")


@cpp_node.check("interrupt", "Ctrl+C ends it cleanly", needs="starts")
def interrupt(recording: Recording) -> None:
    expect_clean_interrupt(recording, NODE)


@cpp_node.check("placeholder", "git keeps the folder for headers", bonus=True, needs=())
def placeholder(recording: Recording) -> None:
    if recording.home.inside(HEADERS):
        return
    state = "is empty" if recording.home.file(HEADERS).exists else "does not exist"
    raise Failure(
        Feedback(
            summary=f"The folder `include/{PACKAGE}` {state}, so git cannot keep it.",
            expected=f"include/{PACKAGE}/.placeholder",
            where=(Location(HEADERS),),
            advice=f"In the package's folder, run `mkdir -p include/{PACKAGE}`, then "
            f"`touch include/{PACKAGE}/.placeholder`.",
        )
    )


# The rover's controller ------------------------------------------------------------------------------

ROVER = "rover_cpp"
CONTROLLER = f"{rover.CONTROLLER}_node"
KEPT = "Store the {} in a member of the class, or it is deleted immediately."

controller = Grader("26-rover")


@controller.scenario
def approach(arena: Arena) -> None:
    """Play the sensor: publish a few distances."""
    commands = arena.ros.subscribe(rover.COMMAND, rover.COMMAND_TYPE)
    sensor = arena.ros.publisher(rover.RANGE, rover.RANGE_TYPE)
    node = arena.run(ROVER, CONTROLLER)
    if node and arena.until(lambda: sensor.matched and arena.ros.graph.nodes, timeout=15, while_running=node):
        rover.measure(arena, sensor.publish, commands, node, *rover.distances())
    arena.interrupt(node)


@controller.check("starts", "the node starts and keeps running")
def controller_starts(recording: Recording) -> None:
    sent = first_reaction(recording, CONTROLLER, (message.t for message in recording.sent(rover.RANGE)))
    expect_running(recording, CONTROLLER, until=sent)


@controller.check("node_name", f"the node is called /{rover.CONTROLLER}", needs="starts")
def controller_name(recording: Recording) -> None:
    expect_node(recording, f"/{rover.CONTROLLER}")


@controller.check("subscribes", f"it subscribes to {rover.RANGE}", needs="starts")
def controller_subscribes(recording: Recording) -> None:
    remedy = f'Call `create_subscription<sensor_msgs::msg::Range>("{rover.RANGE}", 10, ...)`. '
    remedy += KEPT.format("subscription")
    expect_endpoint(recording, "subscription", rover.RANGE, remedy=remedy)
    expect_type(recording, "subscription", rover.RANGE, rover.RANGE_TYPE)
    expect_qos(recording, rover.RANGE)
    if not recording.sent(rover.RANGE):  # it may have existed only for a moment
        raise Failure(
            Feedback(
                summary=f"The subscription to `{rover.RANGE}` was gone before a message arrived.",
                where=text_places(recording.sources, "create_subscription")[:1],
                advice=KEPT.format("subscription"),
            )
        )


@controller.check("publishes", f"it publishes on {rover.COMMAND}", needs="starts")
def controller_publishes(recording: Recording) -> None:
    remedy = f'Call `create_publisher<geometry_msgs::msg::Twist>("{rover.COMMAND}", 10)`. '
    remedy += KEPT.format("publisher")
    expect_endpoint(recording, "publisher", rover.COMMAND, remedy=remedy)
    expect_type(recording, "publisher", rover.COMMAND, rover.COMMAND_TYPE)


@controller.check("survives", "it keeps running while messages arrive", needs=("subscribes", "publishes"))
def controller_survives(recording: Recording) -> None:
    expect_running(recording, CONTROLLER)


@controller.check("speed", "it commands the right speed", points=3, needs="survives")
def commands_speed(recording: Recording) -> None:
    advice = "Subtract 0.5 from `range`, and keep the result between 0.0 and 0.5."
    for distance, speed in rover.answered_distances(recording, -inf, inf):
        rover.expect_speed(recording, distance, speed, rover.safe_speed(distance), advice)


@controller.check("declares", "package.xml declares every package that the node uses")
def controller_dependencies(recording: Recording) -> None:
    expect_dependency(recording, ROVER, "rclcpp", "sensor_msgs", "geometry_msgs")


@controller.check("interrupt", "Ctrl+C ends it cleanly", needs="survives")
def controller_interrupt(recording: Recording) -> None:
    expect_clean_interrupt(recording, CONTROLLER)
