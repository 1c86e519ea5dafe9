"""Grader of chapter 23: what `ros2 launch` starts, and how it ends."""

from __future__ import annotations

from course.api import (
    Arena,
    Failure,
    Grader,
    Recording,
    expect_endpoint,
    expect_launch_file,
    expect_launch_interrupt,
    expect_launched,
    expect_launched_node,
    expect_period,
    expect_type,
    launch_file,
    named,
    replace,
    timer_places,
)

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
    remedy = (
        "The launch file sets it; the node must pass its parameter `topic_name` to `create_publisher`."
        if given
        else f"In the launch file: `'topic_name': '{name}'` among the `parameters`."
    )
    expect_endpoint(recording, "publisher", TOPIC, remedy=remedy)
    expect_type(recording, "publisher", TOPIC, QUOTE)


@launch.check("rate", "it publishes four times per second", points=2, needs="topic")
def rate(recording: Recording) -> None:
    advice = (
        "In the launch file: `'period': 0.25` among the `parameters`, and only one `Node`. In "
        "the node: pass the parameter's value to `create_timer`."
    )
    try:
        expect_period(recording.topic(TOPIC), PERIOD, advice=advice)
    except Failure as failure:
        given = named(launch_file(recording, FILE), "period")
        where = given[:1] or timer_places(recording.sources)[:1]
        raise Failure(replace(failure.feedback, where=where)) from None


@launch.check("interrupt", "one Ctrl+C ends all of it in silence", points=2, needs="launches")
def interrupt(recording: Recording) -> None:
    expect_launch_interrupt(recording, FILE)
