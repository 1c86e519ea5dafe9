"""Graders of chapter 23: what `ros2 launch` starts, and how it ends."""

from __future__ import annotations

from course.api import (
    Arena,
    Failure,
    Feedback,
    Grader,
    Location,
    OurFault,
    Recording,
    calls,
    expect_endpoint,
    expect_launch_file,
    expect_launch_interrupt,
    expect_launch_parameter,
    expect_launched,
    expect_launched_node,
    expect_period,
    expect_type,
    launch_file,
    named,
    replace,
    text_places,
)
from lib import rover

PACKAGE = "python_package_that_uses_parameters_and_launch_files"
FILE = "peanut_butter_falcon_quote_publisher_launch.py"
NODE = "/peanut_butter_falcon_quote_publisher_node"
TOPIC = "/truly_inspirational_quote"
QUOTE = "package_with_interfaces/msg/AmazingQuote"
PERIOD = 0.25
ENOUGH = 5

launch = Grader("23-launch")


@launch.scenario
def one_launch(arena: Arena) -> None:
    """Record five messages, which make four intervals, then press Ctrl+C once.

    It waits long enough for two messages 4 s apart: the period of learners who enter hertz.
    """
    quotes = arena.ros.subscribe(TOPIC, QUOTE)
    launched = arena.launch(PACKAGE, FILE)
    if arena.until(lambda: arena.ros.graph.nodes, timeout=15, while_running=launched) and arena.until(
        lambda: arena.ros.graph.publishers(TOPIC), timeout=4, while_running=launched
    ):
        arena.until(lambda: quotes.count >= 2, timeout=10, while_running=launched)
        if quotes.count >= 2:
            arena.until(lambda: quotes.count >= ENOUGH, timeout=3, while_running=launched)
    arena.interrupt(launched)


@launch.check("launches", "`ros2 launch` starts the launch file, and it keeps running")
def launches(recording: Recording) -> None:
    expect_launch_file(recording, PACKAGE, FILE)
    expect_launched(recording, FILE)


@launch.check("node_name", f"the node is called {NODE}", needs="launches")
def node_name(recording: Recording) -> None:
    expect_launched_node(recording, FILE, NODE)


@launch.check("topic", f"it publishes {QUOTE} on {TOPIC}", needs="launches")
def topic(recording: Recording) -> None:
    name = TOPIC.lstrip("/")
    given = named(launch_file(recording, FILE), name)
    spaced = text_places(launch_file(recording, FILE), "namespace=")
    remedy = (
        "The launch file sets `topic_name`, but the node must also pass it to `create_publisher`."
        if given and not spaced
        else "The launch file's `namespace` comes before the topic's name: remove it."
        if given
        else f"Add `'topic_name': '{name}'` to `parameters` in the launch file."
    )
    try:
        expect_endpoint(recording, "publisher", TOPIC, remedy=remedy)
    except Failure as failure:
        if given:
            raise
        where = text_places(launch_file(recording, FILE), "parameters=")[:1]
        raise Failure(replace(failure.feedback, where=where)) from None
    expect_type(recording, "publisher", TOPIC, QUOTE)


@launch.check("rate", "it publishes four times per second", points=2, needs="topic")
def rate(recording: Recording) -> None:
    advice = (
        "The launch file should set `'period': 0.25` in its `parameters` and start only one `Node`. "
        "The node should pass the parameter's value to `create_timer`."
    )
    try:
        expect_period(recording.topic(TOPIC), PERIOD, advice=advice)
    except Failure as failure:
        given = named(launch_file(recording, FILE), "period")
        where = given[:1] or text_places(launch_file(recording, FILE), "parameters=")[:1]
        raise Failure(replace(failure.feedback, where=where)) from None


@launch.check("interrupt", "one Ctrl+C ends all of it cleanly", points=2, needs="launches")
def interrupt(recording: Recording) -> None:
    expect_launch_interrupt(recording, FILE)


# The rover: its sensor and its controller ------------------------------------------------------------

ROVER_FILE = "rover_launch.py"
SENSOR, CONTROLLER = f"/{rover.SENSOR}", f"/{rover.CONTROLLER}"
DISTANCE, STOP_AT, FULL_SPEED = 2.0, 0.8, 1.0  # m, m, m/s
NEARER = 0.5  # m, the new `stop_at`
NEAR = 0.06  # m; near enough, because the rover becomes slower and slower and never quite arrives
APPROACH, REST = 45, 28  # measurements, ten per second, until it is that near
TUNED = "stop_at was set"

whole = Grader("23-rover")


@whole.scenario
def drive_up_to_the_wall(arena: Arena) -> None:
    """Watch the rover until it stops in front of the wall; then let it come closer."""
    ranges = arena.ros.subscribe(rover.RANGE, rover.RANGE_TYPE)
    commands = arena.ros.subscribe(rover.COMMAND, rover.COMMAND_TYPE)
    sensor, controller = arena.ros.parameters(SENSOR), arena.ros.parameters(CONTROLLER)
    launched = arena.launch(rover.PACKAGE, ROVER_FILE)
    if arena.until(lambda: len(arena.ros.graph.nodes) >= 2, timeout=15, while_running=launched):
        if arena.until(lambda: sensor.available, timeout=3, while_running=launched):
            sensor.get("distance")
        if arena.until(lambda: controller.available, timeout=3, while_running=launched):
            controller.get("stop_at", "full_speed")
        if arena.until(lambda: commands.count, timeout=4, while_running=launched):
            begun = ranges.count  # the sensor may have measured for a while before there is a controller
            arena.until(lambda: ranges.count >= begun + APPROACH, timeout=8, while_running=launched)
            controller.set(stop_at=NEARER)
            arena.mark(TUNED)
            tuned = ranges.count
            arena.until(lambda: ranges.count >= tuned + REST, timeout=6, while_running=launched)
    arena.interrupt(launched)


@whole.check("launches", "`ros2 launch` starts the launch file, and it keeps running")
def rover_launches(recording: Recording) -> None:
    expect_launch_file(recording, rover.PACKAGE, ROVER_FILE)
    expect_launched(recording, ROVER_FILE)


@whole.check("nodes", f"the nodes {SENSOR} and {CONTROLLER} are running", needs="launches")
def nodes(recording: Recording) -> None:
    expect_launched_node(recording, ROVER_FILE, SENSOR)
    expect_launched_node(recording, ROVER_FILE, CONTROLLER)


@whole.check("parameters", "the launch file sets the three parameters", points=2, needs="nodes")
def parameters(recording: Recording) -> None:
    expect_launch_parameter(recording, ROVER_FILE, SENSOR, "distance", DISTANCE)
    expect_launch_parameter(recording, ROVER_FILE, CONTROLLER, "stop_at", STOP_AT)
    expect_launch_parameter(recording, ROVER_FILE, CONTROLLER, "full_speed", FULL_SPEED)


@whole.check("arrives", f"the rover stops {STOP_AT} m in front of the wall", points=2, needs="nodes")
def arrives(recording: Recording) -> None:
    first, last = driven(recording, before=True)
    if first <= DISTANCE + NEAR and abs(last - STOP_AT) <= NEAR:
        return
    parameters(recording)  # a wrong one is the cause
    if first > DISTANCE + NEAR:
        raise Failure(
            Feedback(
                summary=f"The rover starts {first:.2f} m from the wall.",
                expected=f"{DISTANCE} m",
                seen=f"{first:.2f} m",
                where=named(recording.sources, "distance")[:2],
                advice="In the sensor, `self.distance` begins with the value of the parameter `distance`.",
            )
        )
    swapped = abs(last - FULL_SPEED) <= NEAR
    raise Failure(
        elsewhere(
            recording,
            STOP_AT,
            last,
            "It stops where `full_speed` says. The order of the arguments is "
            "`safe_speed(distance, stop_at, full_speed)`."
            if swapped
            else "In the callback, read `stop_at` and `full_speed`, and pass both to `safe_speed`.",
            *(call.where for call in calls(recording.sources, "safe_speed") if swapped),
        )
    )


@whole.check("speed", f"it drives at {FULL_SPEED} m/s at most, and that fast at first", needs="arrives")
def full_speed(recording: Recording) -> None:
    fastest = max((m.data.linear.x for m in recording.topic(rover.COMMAND).messages), default=0.0)
    if abs(fastest - FULL_SPEED) > rover.CLOSE:
        raise Failure(
            Feedback(
                summary=f"The fastest command is {fastest:.2f} m/s.",
                expected=f"{FULL_SPEED} m/s",
                seen=f"{fastest:.2f} m/s",
                where=named(recording.sources, "full_speed")[:2],
                advice="Pass the value of the parameter `full_speed` to `safe_speed`.",
            )
        )


@whole.check("tunes", "a new `stop_at` takes effect while it runs", needs="arrives")
def tunes(recording: Recording) -> None:
    _, last = driven(recording, before=False)
    if abs(last - NEARER) > NEAR:
        raise Failure(
            elsewhere(recording, NEARER, last, "Read the parameter in the callback, not in `__init__`.")
        )


def driven(recording: Recording, *, before: bool) -> tuple[float, float]:
    """The first and the last distance (m) before `stop_at` was set, or after it."""
    tuned = recording.marked(TUNED)
    received = recording.topic(rover.RANGE).messages
    found = [m.data.range for m in received if tuned and (m.t < tuned.t) == before]
    if found:
        return found[0], found[-1]
    moves = recording.topic(rover.COMMAND).messages
    if received and moves:
        raise OurFault("the scenario did not see the rover drive")
    topic, other = (rover.RANGE, "sensor") if not received else (rover.COMMAND, "controller")
    raise Failure(
        Feedback(
            summary=f"No messages arrive on `{topic}`.",
            advice=f"Start the {other} alone, and look at `ros2 topic echo {topic}`.",
        )
    )


def elsewhere(recording: Recording, wanted: float, seen: float, advice: str, *where: Location) -> Feedback:
    return Feedback(
        summary=f"`stop_at` is {wanted} m, but the rover is {seen:.2f} m from the wall.",
        expected=f"{wanted} m",
        seen=f"{seen:.2f} m",
        where=where or named(recording.sources, "stop_at")[:2],
        advice=advice,
    )


@whole.check("interrupt", "one Ctrl+C ends all of it cleanly", needs="launches")
def rover_interrupt(recording: Recording) -> None:
    expect_launch_interrupt(recording, ROVER_FILE)
