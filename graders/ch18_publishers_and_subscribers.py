"""Graders of chapter 18: a publisher and a subscriber for our own messages, and a node that is both."""

from __future__ import annotations

import secrets
from collections.abc import Callable, Mapping
from functools import partial
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from course.api import (
    Arena,
    Cause,
    Failure,
    Feedback,
    Grader,
    Message,
    Recording,
    Sources,
    Spoilt,
    about,
    calls,
    cause_of_silence,
    expect_clean_interrupt,
    expect_dependency,
    expect_endpoint,
    expect_node,
    expect_period,
    expect_qos,
    expect_running,
    expect_type,
    slips,
    text_places,
    words,
)
from lib import rover
from lib.deliveries import expect_contents, expect_deliveries, first_reaction
from lib.interfaces import expect_same_definition

if TYPE_CHECKING:
    from course.api import Listener

PACKAGE = "python_package_that_uses_the_messages"
INTERFACES = "package_with_interfaces"
QUOTE = f"{INTERFACES}/msg/AmazingQuote"
QUOTE_HASH = "RIHS01_6eb8a339124c22e6ee8541e6132c3bccee5a2125c643270c85cae174a4aaeb21"
TOPIC = "/amazing_quote"
PUBLISHER = "amazing_quote_publisher_node"
SUBSCRIBER = "amazing_quote_subscriber_node"
ENOUGH = 5
COMPARE = (
    "Compare the names, types, and order of its fields with chapter 17. `ros2course check 17` shows the "
    "difference."
)

publisher = Grader("18-publisher")
subscriber = Grader("18-subscriber")


@publisher.scenario
def five_quotes(arena: Arena) -> None:
    """Record five messages, which make four intervals. Don't wait as long for a node without that topic."""
    quotes = arena.ros.subscribe(TOPIC, QUOTE)
    node = arena.run(PACKAGE, PUBLISHER)
    if node and arena.until(lambda: arena.ros.graph.nodes, timeout=15, while_running=node):
        arena.until(lambda: arena.ros.graph.topics_of("publisher"), timeout=8, while_running=node)
        arena.until(lambda: quotes.count, timeout=4, while_running=node)
        if quotes.count:
            arena.until(lambda: quotes.count >= ENOUGH, timeout=5, while_running=node)
    arena.interrupt(node)


@publisher.check("starts", "the node starts and keeps running")
def publisher_starts(recording: Recording) -> None:
    expect_running(recording, PUBLISHER)


@publisher.check("node_name", f"the node is called /{PUBLISHER}", needs="starts")
def publisher_name(recording: Recording) -> None:
    expect_node(recording, f"/{PUBLISHER}")


@publisher.check("topic_exists", f"it has a publisher on {TOPIC}", needs="starts")
def topic_exists(recording: Recording) -> None:
    remedy = f"Create it: `self.create_publisher(AmazingQuote, '{TOPIC}', 10)`."
    expect_endpoint(about(recording, PACKAGE, PUBLISHER, PUBLISHER), "publisher", TOPIC, remedy=remedy)


@publisher.check("right_type", f"the topic's type is {QUOTE}", needs="topic_exists")
def publisher_type(recording: Recording) -> None:
    expect_type(recording, "publisher", TOPIC, QUOTE)
    expect_same_definition(recording, "publisher", TOPIC, QUOTE, QUOTE_HASH, advice=COMPARE)


@publisher.check("publishes", "messages arrive", needs="right_type")
def publishes(recording: Recording) -> None:
    received = recording.topic(TOPIC).messages
    if len(received) > 1:
        return
    cause = cause_of_silence(recording, PUBLISHER, look_at="does the timer's callback reach `publish(...)`?")
    unused = not calls(recording.sources, "publish")
    raise Failure(
        Feedback(
            summary="The publisher exists, but no message arrives."
            if not received
            else "Only one message arrived.",
            expected="a message every 0.5 s",
            seen=f"{len(received)} in {recording.duration:.1f} s",
            where=cause.where,
            advice="Nothing uses the publisher: call `self.publisher.publish(message)` in the "
            "timer's callback."
            if unused
            else cause.text,
        )
    )


@publisher.check("rate", "it publishes twice per second", points=2, needs="publishes")
def rate(recording: Recording) -> None:
    own = about(recording, PACKAGE, PUBLISHER, PUBLISHER)
    expect_period(recording.topic(TOPIC), 0.5, program=own)


@publisher.check("ids", "id goes up by one with each message", needs="publishes")
def ids(recording: Recording) -> None:
    if recording.lost(TOPIC):
        raise Spoilt(f"{recording.lost(TOPIC)} messages on `{TOPIC}` were lost on their way to the grader.")
    numbers = [message.data.id for message in recording.topic(TOPIC).messages]
    steps = {later - earlier for earlier, later in pairwise(numbers)}
    if steps == {1}:
        return
    shown = ", ".join(map(str, numbers[:ENOUGH]))
    seen = f"id goes {shown}" if len(steps) > 1 else f"id changes by {steps.pop()} each time: {shown}"
    constant = len(set(numbers)) == 1
    cause = slips.first(recording.sources, slips.filled_late, slips.compared, slips.never_counts)
    raise Failure(
        Feedback(
            summary=f"`id` is always {numbers[0]}." if constant else "`id` does not go up by one.",
            expected="0, 1, 2, 3, 4",
            seen=seen,
            where=cause.where
            if cause
            else tuple(call.where for call in calls(recording.sources, "publish"))[:1],
            advice=cause.text
            if cause
            else "Keep the next number in the node. Set `message.id` to it, and add one after publishing.",
        )
    )


@publisher.check("texts", "quote and philosopher_name are not empty", needs="publishes")
def texts(recording: Recording) -> None:
    for message in recording.topic(TOPIC).messages:
        for field in ("quote", "philosopher_name"):
            if not getattr(message.data, field).strip():
                published = tuple(call.where for call in calls(recording.sources, "publish"))
                advice = f"Set it before publishing: `message.{field} = '...'`."
                cause = slips.compared(recording.sources) or Cause(advice, published[:1])
                raise Failure(
                    Feedback(
                        summary=f"`{field}` is empty in the message with id {message.data.id}.",
                        expected="at least one character",
                        seen="an empty string",
                        where=cause.where,
                        advice=cause.text,
                    )
                )


@publisher.check("declares_messages", "package.xml declares rclpy and package_with_interfaces")
def publisher_dependencies(recording: Recording) -> None:
    expect_dependency(recording, PACKAGE, "rclpy", INTERFACES)


@publisher.check("interrupt", "Ctrl+C ends it cleanly", needs="starts")
def publisher_interrupt(recording: Recording) -> None:
    expect_clean_interrupt(recording, PUBLISHER)


@subscriber.scenario
def six_quotes_to_hear(arena: Arena) -> None:
    """Publish each quote after the previous one was logged, or after some time."""
    speaker = arena.ros.publisher(TOPIC, QUOTE)
    node = arena.run(PACKAGE, SUBSCRIBER)
    if node and arena.until(lambda: arena.ros.graph.nodes, timeout=15, while_running=node):
        arena.until(lambda: arena.ros.graph.topics_of("subscription"), timeout=8, while_running=node)
        arena.until(lambda: speaker.matched, timeout=3, while_running=node)
        if speaker.matched:
            arena.say(speaker, quotes_to_say(), partial(is_logged, arena), while_running=node)
    arena.interrupt(node)


def is_logged(arena: Arena, quote: Mapping[str, Any]) -> bool:
    return all(arena.logged(str(part)) for part in quote.values() if part)


@subscriber.check("starts", "the node starts and keeps running")
def subscriber_starts(recording: Recording) -> None:
    """Expect it to run until the first message. The check `survives` judges the rest."""
    first = first_reaction(recording, SUBSCRIBER, (message.t for message in recording.sent(TOPIC)))
    expect_running(recording, SUBSCRIBER, until=first)


@subscriber.check("node_name", f"the node is called /{SUBSCRIBER}", needs="starts")
def subscriber_name(recording: Recording) -> None:
    expect_node(recording, f"/{SUBSCRIBER}")


@subscriber.check("subscribes", f"it has a subscription on {TOPIC}", needs="starts")
def subscribes(recording: Recording) -> None:
    remedy = f"Create it: `self.create_subscription(AmazingQuote, '{TOPIC}', callback, 10)`."
    expect_endpoint(about(recording, PACKAGE, SUBSCRIBER, SUBSCRIBER), "subscription", TOPIC, remedy=remedy)


@subscriber.check("right_type", f"the topic's type is {QUOTE}", needs="subscribes")
def subscriber_type(recording: Recording) -> None:
    expect_type(recording, "subscription", TOPIC, QUOTE)
    expect_same_definition(recording, "subscription", TOPIC, QUOTE, QUOTE_HASH, advice=COMPARE)


@subscriber.check("qos", "its QoS profile matches an ordinary publisher's", needs="right_type")
def qos(recording: Recording) -> None:
    expect_qos(recording, TOPIC)


@subscriber.check("survives", "it keeps running while messages arrive", needs="qos")
def survives(recording: Recording) -> None:
    expect_running(recording, SUBSCRIBER)


@subscriber.check("receives", "it logs each message", needs="survives")
def receives(recording: Recording) -> None:
    expect_deliveries(recording, SUBSCRIBER, TOPIC)


@subscriber.check(
    "content", "quote, philosopher_name, and id are in the log once", points=2, needs="receives"
)
def content(recording: Recording) -> None:
    expect_contents(recording, TOPIC, ("quote", "philosopher_name", "id"), once="quote")


@subscriber.check("declares_messages", "package.xml declares rclpy and package_with_interfaces")
def subscriber_dependencies(recording: Recording) -> None:
    expect_dependency(recording, PACKAGE, "rclpy", INTERFACES)


@subscriber.check("interrupt", "Ctrl+C ends it cleanly", needs="survives")
def subscriber_interrupt(recording: Recording) -> None:
    expect_clean_interrupt(recording, SUBSCRIBER)


def quotes_to_say() -> list[dict[str, Any]]:
    """Six AmazingQuotes as dicts: plain, unicode, quotes within quotes, empty, long, plain.

    The texts are random, so a node can get them only from the message. The ids have five digits and
    alternate between odd and even, except for a zero.
    """
    texts = [
        words(4),
        f"{words(2)} häufig – çà et là, 日本語 ✓ {words(1)}",
        f"{words(1)} said: \"{words(2)} 'and' {words(1)}\"",
        "",
        words(60),
        words(5),
    ]
    start = 10_000 + secrets.randbelow(80_000)
    return [
        {
            "id": 0 if index == 4 else start + 7 * index,
            "quote": text,
            "philosopher_name": f"Professor {words(1)} {words(1)}",
        }
        for index, text in enumerate(texts)
    ]


# The rover's sensor: a publisher and a subscriber in one node ------------------------------------------

SENSOR = f"{rover.SENSOR}_node"
START, PACE = 3.0, 0.1
STANDS, DRIVES, HALTS, RACES = "no command", "a command", "a command to stop", "a fast command"
AWAIT = 12  # measurements after each command
LATE = 2  # this many of them may have been sent before the command arrived
TOLERANCE = 0.25

sensor = Grader("18-rover")


@sensor.scenario
def drive_to_the_wall(arena: Arena) -> None:
    """Let it wait, drive at a random speed, stop, and drive into the wall."""
    ranges = arena.ros.subscribe(rover.RANGE, rover.RANGE_TYPE)
    driver = arena.ros.publisher(rover.COMMAND, rover.COMMAND_TYPE)
    node = arena.run(rover.PACKAGE, SENSOR)
    if node and arena.until(lambda: ranges.count and arena.ros.graph.nodes, timeout=15, while_running=node):
        arena.until(lambda: driver.matched, timeout=4, while_running=node)
        for phase, speed in (
            (STANDS, None),
            (DRIVES, 0.4 + secrets.randbelow(50) / 100),
            (HALTS, 0.0),
            (RACES, 99.0),
        ):
            arena.mark(phase)
            if speed is not None:
                driver.publish(linear={"x": speed})
            enough = ranges.count + AWAIT
            if not arena.until(partial(at_least, ranges, enough), timeout=4, while_running=node):
                break
    arena.interrupt(node)


def at_least(ranges: Listener, number: int) -> bool:
    return ranges.count >= number


@sensor.check("starts", "the node starts and keeps running")
def sensor_starts(recording: Recording) -> None:
    expect_running(recording, SENSOR)


@sensor.check("node_name", f"the node is called /{rover.SENSOR}", needs="starts")
def sensor_name(recording: Recording) -> None:
    expect_node(recording, f"/{rover.SENSOR}")


@sensor.check("publishes", f"it publishes on {rover.RANGE}", needs="starts")
def sensor_publishes(recording: Recording) -> None:
    remedy = f"Create a publisher: `self.create_publisher(Range, '{rover.RANGE}', 10)`."
    expect_endpoint(about_sensor(recording), "publisher", rover.RANGE, remedy=remedy)
    expect_type(recording, "publisher", rover.RANGE, rover.RANGE_TYPE)


@sensor.check("subscribes", f"it subscribes to {rover.COMMAND}", needs="starts")
def sensor_subscribes(recording: Recording) -> None:
    remedy = f"Create it: `self.create_subscription(Twist, '{rover.COMMAND}', self.command_callback, 10)`."
    expect_endpoint(about_sensor(recording), "subscription", rover.COMMAND, remedy=remedy)
    expect_type(recording, "subscription", rover.COMMAND, rover.COMMAND_TYPE)
    expect_qos(recording, rover.COMMAND)


@sensor.check("rate", "it publishes ten times per second", needs="publishes")
def sensor_rate(recording: Recording) -> None:
    expect_period(recording.topic(rover.RANGE), PACE, program=about_sensor(recording))


@sensor.check("stands", "without a command, the distance stays at 3.0 m", needs="rate")
def stands(recording: Recording) -> None:
    for message in during(recording, None, DRIVES):
        if abs(message.data.range - START) > rover.CLOSE:
            advice = "Start with a distance of 3.0 and a speed of 0.0. Only commands change the speed."
            summary = "The distance is not 3.0 m before the first command."
            raise Failure(
                wrong_range(recording, summary, f"{START}", message, advice, slips.never_above_zero)
            )


@sensor.check("drives", "a command brings the wall closer", points=2, needs=("stands", "subscribes"))
def drives(recording: Recording) -> None:
    """Expect the distance to fall by the speed, either per second or per period in the task."""
    command = recording.sent(rover.COMMAND)[0].data.linear.x
    first, *_, last = found = during(recording, DRIVES, HALTS)
    fallen = first.data.range - last.data.range
    paces = (fallen / (last.t - first.t), fallen / (PACE * (len(found) - 1)))
    # If the period is left out, the rover hits the wall at once, and its pace means nothing.
    at_once = last.data.range < rover.CLOSE and command * (last.t - first.t) < START - 1
    if at_once or not any(abs(pace / command - 1) <= TOLERANCE for pace in paces):
        stored = text_places(recording.sources, "linear.x")[:1]
        way = "subtract this speed times 0.1 s from the distance."
        raise Failure(
            Feedback(
                summary=f"At {command:.2f} m/s, the distance does not fall by {command:.2f} m per second.",
                expected=f"{command:.2f} m per second",
                seen="it is at the wall at once" if at_once else f"{paces[0]:.2f} m per second",
                where=() if at_once or fallen < 0 else stored,
                advice=f"It drives too far in each period: {way}"
                if at_once
                else f"It drives away from the wall: {way}"
                if fallen < 0
                else f"Store `linear.x` from each command. In the timer's callback, {way}",
            )
        )


@sensor.check("halts", "at speed 0, the distance stays the same", needs="drives")
def halts(recording: Recording) -> None:
    first, *others = during(recording, HALTS, RACES)
    for message in others:
        if abs(message.data.range - first.data.range) > rover.CLOSE:
            advice = "Set the speed to `linear.x` from each command, even if it is 0.0. Don't add to it."
            summary = "The command is 0, but the distance changes."
            raise Failure(wrong_range(recording, summary, "the same", message, advice, code="linear.x"))


@sensor.check("wall", "the distance is never below zero", needs="drives")
def wall(recording: Recording) -> None:
    last = during(recording, RACES, None)[-1]
    if abs(last.data.range) > rover.CLOSE:
        advice = "Keep the distance at zero or above. Use `max(0.0, ...)`, which is never below zero."
        raise Failure(wrong_range(recording, "At the wall, the distance is not 0.0.", "0.0", last, advice))


def wrong_range(
    recording: Recording,
    summary: str,
    expected: str,
    message: Message,
    advice: str,
    *causes: Callable[[Sources], Cause | None],
    code: str = ".range = ",
) -> Feedback:
    """causes: they look in the code for a better advice. code: a part of the line to look at otherwise."""
    places = text_places(recording.sources, code)
    cause = slips.first(recording.sources, *causes) or Cause(advice, places[:1])
    return Feedback(
        summary=summary,
        expected=expected,
        seen=f"range is {message.data.range:.3f}",
        where=cause.where,
        advice=cause.text,
    )


def during(recording: Recording, begin: str | None, end: str | None) -> list[Message]:
    """The measurements between two marks, except those that may be from before the command."""
    received = recording.topic(rover.RANGE).messages
    start, stop = (recording.marked(name) if name else None for name in (begin, end))
    found = [m for m in received if (not start or m.t > start.t) and (not stop or m.t < stop.t)]
    found = found[LATE if begin else 0 :]
    if len(found) < 2:
        where = text_places(recording.sources, "linear.x")[:1]
        advice = "A callback must return soon, because nothing else in the node can run until it does."
        raise Failure(Feedback(f"After {begin}, no more distances arrive.", where=where, advice=advice))
    return found


def about_sensor(recording: Recording) -> Recording:
    return about(recording, rover.PACKAGE, SENSOR, rover.SENSOR)


@sensor.check("declares", "package.xml declares rclpy, sensor_msgs, and geometry_msgs")
def sensor_dependencies(recording: Recording) -> None:
    expect_dependency(recording, rover.PACKAGE, "rclpy", "sensor_msgs", "geometry_msgs")


@sensor.check("interrupt", "Ctrl+C ends it cleanly", needs="starts")
def sensor_interrupt(recording: Recording) -> None:
    expect_clean_interrupt(recording, SENSOR)
