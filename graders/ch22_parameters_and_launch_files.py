"""Graders of chapter 22: a node with parameters, and a launch file that sets them."""

from __future__ import annotations

import json
import secrets
from math import inf
from typing import TYPE_CHECKING

from course.api import (
    Arena,
    Call,
    Failure,
    Feedback,
    Grader,
    Message,
    OurFault,
    Parameters,
    Process,
    Recording,
    Sources,
    TopicView,
    calls,
    cause_of_silence,
    expect_clean_interrupt,
    expect_declared,
    expect_dependency,
    expect_endpoint,
    expect_launch_file,
    expect_launch_parameter,
    expect_launched,
    expect_launched_node,
    expect_node,
    expect_own_launch_parameter,
    expect_parameter,
    expect_period,
    expect_running,
    expect_set,
    expect_type,
    launch_file,
    replace,
    timer_places,
    words,
)
from lib.configured import expect_followed, expect_period_kept, expect_texts
from lib.interfaces import expect_same_definition

if TYPE_CHECKING:
    from course.api import Listener

PACKAGE = "python_package_that_uses_parameters_and_launch_files"
EXECUTABLE = "amazing_quote_configurable_publisher_node"
NODE = f"/{EXECUTABLE}"
INTERFACES = "package_with_interfaces"
QUOTE = f"{INTERFACES}/msg/AmazingQuote"
QUOTE_HASH = "RIHS01_6eb8a339124c22e6ee8541e6132c3bccee5a2125c643270c85cae174a4aaeb21"
COMPARE = (
    "Compare the fields with chapter 17: their names, types, and order. `ros2course check 17` shows "
    "the difference."
)
TEXTS = ("quote", "philosopher_name")
DEFAULTS: dict[str, str | float] = {
    "quote": "Use the force, Pikachu!",
    "philosopher_name": "Uncle Ben",
    "topic_name": "amazing_quote",
    "period": 0.5,
}
TOPIC = f"/{DEFAULTS['topic_name']}"
NOT_TAKEN = (
    "`--ros-args -p` replaces the default value if you call `rclpy.init(args=args)`, declare "
    "the parameter without `ignore_override`, and do not set it yourself."
)
PERIOD, GIVEN_PERIOD, LATER_PERIOD = 0.5, 0.2, 0.05
SECOND_RUN = f"{EXECUTABLE} with other values"
# The grader also listens on a topic that no parameter names: else a node could find its topic in the graph.
DECOY = "a topic that no parameter names"
ENOUGH = 5
# A message that was on its way when the change was confirmed may still be an old one.
AFTER_A_CHANGE = 3
ATTEMPTS = 5

LAUNCH_FILE = "peanut_butter_falcon_quote_publisher_launch.py"
FALCON = "/peanut_butter_falcon_quote_publisher_node"
FALCON_TOPIC = "truly_inspirational_quote"
FALCON_PERIOD = 0.25

parameters = Grader("22-parameters")
launch = Grader("22-launch")


# The node --------------------------------------------------------------------------------------------


@parameters.scenario
def defaults_then_others(arena: Arena) -> None:
    """Run the node with its defaults; then with values from the command line, and changes meanwhile."""
    asked, values, decoy = arena.ros.parameters(NODE), other_values(), f"/{other_values()['topic_name']}"
    quotes, others = arena.ros.subscribe(TOPIC, QUOTE), arena.ros.subscribe(f"/{values['topic_name']}", QUOTE)
    arena.ros.subscribe(decoy, QUOTE)
    arena.mark(DECOY, decoy)
    with arena.fresh():
        goes_on = as_it_is(arena, asked, quotes)
    if goes_on:
        arena.mark(SECOND_RUN, json.dumps(values))
        with arena.fresh():
            with_others(arena, asked, others, values)


def other_values() -> dict[str, str | float]:
    """Values for the second run's command line. A program that counts its runs cannot know them."""
    topic = f"quotes_by_request_{secrets.randbelow(10**6)}"
    texts = {name: words(4) for name in TEXTS}
    return {**texts, "topic_name": topic, "period": GIVEN_PERIOD}


def as_it_is(arena: Arena, asked: Parameters, quotes: Listener) -> bool:
    """Whether the node reported its parameters and published, so that a second run can show more."""
    node = arena.run(PACKAGE, EXECUTABLE)
    told = False
    if node and arena.until(lambda: arena.ros.graph.nodes, timeout=15, while_running=node):
        told = ask(arena, asked, node)
        arena.until(lambda: arena.ros.graph.topics_of("publisher"), timeout=8, while_running=node)
        arena.until(lambda: quotes.count, timeout=4, while_running=node)
        if quotes.count:
            arena.until(lambda: quotes.count >= ENOUGH, timeout=5, while_running=node)
    arena.interrupt(node)
    return told and quotes.count > 0


def ask(arena: Arena, asked: Parameters, node: Process) -> bool:
    """Ask for names and values repeatedly: requests are lost until ROS has matched both sides."""
    if not arena.until(lambda: asked.node in arena.ros.graph.nodes, timeout=6, while_running=node):
        return False
    arena.until(lambda: asked.available, timeout=4, while_running=node)
    return any(answers(arena, (*asked.get(*DEFAULTS), asked.list()), node) for _ in range(ATTEMPTS))


def answers(arena: Arena, calls: tuple[Call, ...], node: Process) -> bool:
    return arena.until(lambda: all(call.done for call in calls), timeout=1, while_running=node)


def with_others(arena: Arena, asked: Parameters, others: Listener, values: dict[str, str | float]) -> None:
    # The first node is still known for a moment, but never answers.
    arena.until(lambda: asked.node not in arena.ros.graph.nodes, timeout=2)
    node = arena.run(PACKAGE, EXECUTABLE, params=values, name=SECOND_RUN)
    arena.until(lambda: asked.node in arena.ros.graph.nodes, timeout=15, while_running=node)
    if node and ask(arena, asked, node):
        arena.until(lambda: others.count, timeout=3, while_running=node)
        if others.count:
            arena.until(lambda: others.count >= ENOUGH, timeout=4, while_running=node)
            change(arena, asked, others, node, AFTER_A_CHANGE, {name: words(4) for name in TEXTS})
            change(arena, asked, others, node, ENOUGH, {"period": LATER_PERIOD})
    arena.interrupt(node)


def change(
    arena: Arena,
    asked: Parameters,
    others: Listener,
    node: Process,
    enough: int,
    values: dict[str, str] | dict[str, float],
) -> None:
    """Set these parameters, and hear this many more messages."""
    call = asked.set(values)
    arena.until(lambda: call.done, timeout=2, while_running=node)
    before = others.count
    arena.until(lambda: others.count >= before + enough, timeout=3, while_running=node)


def second_run(recording: Recording) -> float:
    """When the run with other values began; infinity if it did not."""
    found = recording.marked(SECOND_RUN)
    return found.t if found else inf


def given(recording: Recording) -> dict[str, str | float]:
    """The values of the second run."""
    found = recording.marked(SECOND_RUN)
    if found is None:
        raise OurFault("the run with other values is missing")
    values: dict[str, str | float] = json.loads(found.detail)
    return values


def given_topic(recording: Recording) -> str:
    return f"/{given(recording)['topic_name']}"


def node_alone(recording: Recording) -> Recording:
    """The node without the launch file, which has the same parameters but is never the cause."""
    files = recording.sources.files
    own = {path: text for path, text in files.items() if "/launch/" not in path}
    return replace(recording, sources=Sources(own, recording.sources.others))


def as_it_was(recording: Recording) -> tuple[Message, ...]:
    return tuple(m for m in recording.messages(TOPIC) if m.t < second_run(recording))


def set_at(recording: Recording, name: str) -> tuple[float, float]:
    """When the scenario set this parameter, and when that was answered."""
    found = [result for result in recording.parameters(NODE).sets if result.name == name]
    if not found:
        raise OurFault(f"the scenario did not set {name}")
    return found[0].asked, found[0].answered or found[0].asked


@parameters.check("starts", "the node starts and keeps running")
def starts(recording: Recording) -> None:
    expect_running(node_alone(recording), EXECUTABLE)


@parameters.check("node_name", f"the node is called {NODE}", needs="starts")
def node_name(recording: Recording) -> None:
    expect_node(node_alone(recording), NODE)


@parameters.check("declared", "it declares its four parameters", needs="node_name")
def declared(recording: Recording) -> None:
    own = node_alone(recording)
    for name, default in DEFAULTS.items():
        try:
            expect_declared(own, NODE, name, default)
        except Failure as failure:
            where = failure.feedback.where or tuple(call.where for call in calls(own.sources, "__init__"))[:1]
            raise Failure(replace(failure.feedback, where=where)) from None


@parameters.check("defaults", "they have the right types and default values", points=2, needs="declared")
def defaults(recording: Recording) -> None:
    for name, default in DEFAULTS.items():
        try:
            expect_parameter(node_alone(recording), NODE, name, default, t=second_run(recording))
        except Failure as failure:
            written = f"`self.declare_parameter('{name}', {default!r})`."
            advice = failure.feedback.advice or f"The default value is set where it is declared: {written}"
            raise Failure(replace(failure.feedback, advice=advice)) from None


@parameters.check("topic_exists", f"by default it publishes on {TOPIC}", needs="starts")
def topic_exists(recording: Recording) -> None:
    remedy = "Create a publisher on the topic in the parameter `topic_name`."
    expect_endpoint(node_alone(recording), "publisher", TOPIC, remedy=remedy)


@parameters.check("right_type", f"the topic's type is {QUOTE}", needs="topic_exists")
def right_type(recording: Recording) -> None:
    expect_type(recording, "publisher", TOPIC, QUOTE)
    expect_same_definition(recording, "publisher", TOPIC, QUOTE, QUOTE_HASH, advice=COMPARE)


@parameters.check("publishes", "messages arrive", needs="right_type")
def publishes(recording: Recording) -> None:
    came = as_it_was(recording)
    if len(came) > 1:
        return
    cause = cause_of_silence(
        recording,
        EXECUTABLE,
        look_at="does the timer's callback reach `publish(...)`, and is its period in seconds?",
    )
    raise Failure(
        Feedback(
            summary="One message arrived, but no more after it."
            if came
            else "The publisher exists, but no message arrives.",
            expected="a message every 0.5 s",
            seen=f"{len(came)} messages",
            where=cause.where,
            advice=cause.text,
        )
    )


@parameters.check("rate", "by default it publishes twice per second", needs="publishes")
def rate(recording: Recording) -> None:
    expect_pace(recording, recording.topic(TOPIC).between(0.0, second_run(recording)), PERIOD)


def expect_pace(recording: Recording, topic: TopicView, period: float) -> None:
    advice = "Pass the parameter's value to `create_timer`: `self.get_parameter('period').value`."
    where = timer_places(recording.sources)[:2]
    expect_period(
        topic, period, what="messages", advice=advice, where=where, program=recording, written=False
    )


@parameters.check("says", "the messages contain the quote and the philosopher's name", needs="publishes")
def says(recording: Recording) -> None:
    told = recording.parameters(NODE).at(second_run(recording))
    wanted = {name: str(told[name].value if name in told else DEFAULTS[name]) for name in TEXTS}
    for message in as_it_was(recording):
        expect_texts(recording, message, wanted)


@parameters.check(
    "others_start", "it starts with other values on the command line", needs=("defaults", "publishes")
)
def others_start(recording: Recording) -> None:
    expect_running(node_alone(recording), SECOND_RUN)


@parameters.check("others_taken", "its parameters then have those values", needs="others_start")
def others_taken(recording: Recording) -> None:
    for name, value in given(recording).items():
        try:
            expect_parameter(node_alone(recording), NODE, name, value)
        except Failure as failure:
            where = (*failure.feedback.where, *(call.where for call in calls(recording.sources, "init")))
            raise Failure(replace(failure.feedback, advice=NOT_TAKEN, where=where[:2])) from None


def on_its_own_account(recording: Recording, topic: str, other: str) -> Feedback:
    return Feedback(
        summary=f"With `topic_name` set to `{topic[1:]}`, the node also publishes on `{other}`."
        if other == TOPIC
        else f"The node publishes on `{other}`, which `topic_name` never named.",
        expected=f"{topic} only",
        seen=other,
        where=tuple(call.where for call in calls(recording.sources, "create_publisher"))[:2],
        advice="Create one publisher, on the topic in `self.get_parameter('topic_name').value`.",
    )


@parameters.check("others_topic", "it publishes on the topic that topic_name names", needs="others_taken")
def others_topic(recording: Recording) -> None:
    topic = given_topic(recording)
    received, decoy = recording.topic(topic).messages, recording.marked(DECOY)
    if decoy and recording.messages(decoy.detail):
        raise Failure(on_its_own_account(recording, topic, decoy.detail))
    if received and any(message.t > received[0].t for message in recording.messages(TOPIC)):
        raise Failure(on_its_own_account(recording, topic, TOPIC))
    if received:
        return
    elsewhere = [message for message in recording.messages(TOPIC) if message.t > second_run(recording)]
    if not elsewhere:
        rate(recording)  # at a wrong pace, a message may come too late
    raise Failure(
        Feedback(
            summary=f"With `topic_name` set to `{topic[1:]}`, the node still publishes on `{TOPIC}`."
            if elsewhere
            else f"With `topic_name` set to `{topic[1:]}`, nothing arrives on that topic.",
            expected=topic,
            seen=TOPIC if elsewhere else "no message",
            where=tuple(call.where for call in calls(recording.sources, "create_publisher"))[:2],
            advice=(
                "Pass the parameter's value to `create_publisher`, "
                "`self.get_parameter('topic_name').value`, instead of a fixed name."
            ),
        )
    )


@parameters.check("others_rate", "it publishes as often as period says", needs="others_topic")
def others_rate(recording: Recording) -> None:
    until, _ = set_at(recording, "period")
    expect_pace(recording, recording.topic(given_topic(recording)).between(0.0, until), GIVEN_PERIOD)


@parameters.check("others_say", "its messages contain the given texts", needs="others_topic")
def others_say(recording: Recording) -> None:
    until, _ = set_at(recording, TEXTS[0])
    for message in recording.messages(given_topic(recording)):
        if message.t < until:
            expect_texts(recording, message, {name: str(given(recording)[name]) for name in TEXTS})


@parameters.check(
    "changes", "a change of quote or philosopher_name is in the next message", points=2, needs="others_say"
)
def changes(recording: Recording) -> None:
    for name in TEXTS:
        expect_set(recording, NODE, name)
        expect_followed(node_alone(recording), NODE, given_topic(recording), name)


@parameters.check("period_stays", "a change of period does not change the rate", needs="others_rate")
def period_stays(recording: Recording) -> None:
    _, since = set_at(recording, "period")
    topic = recording.topic(given_topic(recording)).between(since, inf)
    expect_period_kept(node_alone(recording), topic, GIVEN_PERIOD, parameter="period", value=LATER_PERIOD)


@parameters.check("declares_messages", f"package.xml declares rclpy and {INTERFACES}")
def dependencies(recording: Recording) -> None:
    expect_dependency(recording, PACKAGE, "rclpy", INTERFACES)


@parameters.check("interrupt", "Ctrl+C ends it cleanly", needs="starts")
def interrupt(recording: Recording) -> None:
    expect_clean_interrupt(recording, EXECUTABLE)


# The launch file -------------------------------------------------------------------------------------


@launch.scenario
def one_launch(arena: Arena) -> None:
    """The node's parameters show what the launch file passed; chapter 23 checks what it does with them."""
    asked = arena.ros.parameters(FALCON)
    launched = arena.launch(PACKAGE, LAUNCH_FILE)
    if arena.until(lambda: arena.ros.graph.nodes, timeout=15, while_running=launched):
        ask(arena, asked, launched)
    arena.interrupt(launched)


@launch.check("installed", "the package installs the launch file")
def installed(recording: Recording) -> None:
    expect_launch_file(recording, PACKAGE, LAUNCH_FILE)


@launch.check("launches", "`ros2 launch` starts it, and it keeps running", points=2, needs="installed")
def launches(recording: Recording) -> None:
    expect_launched(recording, LAUNCH_FILE)


@launch.check("node_name", f"the node is called {FALCON}", needs="launches")
def falcon_name(recording: Recording) -> None:
    expect_launched_node(recording, LAUNCH_FILE, FALCON)


@launch.check("once", f"there is one {EXECUTABLE}", needs="launches")
def once(recording: Recording) -> None:
    names = [name for name in recording.launched(LAUNCH_FILE).processes if name.startswith(f"{EXECUTABLE}-")]
    if len(names) > 1:
        raise Failure(
            Feedback(
                summary=f"The launch file starts `{EXECUTABLE}` {len(names)} times.",
                expected="once",
                seen=", ".join(names),
                where=tuple(call.where for call in calls(launch_file(recording, LAUNCH_FILE), "Node")),
                advice="One `Node(...)` is enough.",
            )
        )


@launch.check("topic_name", f"topic_name is {FALCON_TOPIC}", needs="node_name")
def falcon_topic(recording: Recording) -> None:
    expect_launch_parameter(recording, LAUNCH_FILE, FALCON, "topic_name", FALCON_TOPIC)


@launch.check("period", f"period is {FALCON_PERIOD}", needs="node_name")
def falcon_period(recording: Recording) -> None:
    expect_launch_parameter(recording, LAUNCH_FILE, FALCON, "period", FALCON_PERIOD)


@launch.check("texts", "quote and philosopher_name are your own choice", needs="node_name")
def falcon_texts(recording: Recording) -> None:
    for name in TEXTS:
        expect_own_launch_parameter(recording, LAUNCH_FILE, FALCON, name, DEFAULTS[name])
