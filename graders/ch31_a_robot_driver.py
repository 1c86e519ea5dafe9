"""Graders of chapter 31: a robot's driver, its launch file, a client, and a driver in Python."""

from __future__ import annotations

import math
import re
import signal
import stat
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from itertools import dropwhile
from operator import itemgetter
from pathlib import Path
from typing import TYPE_CHECKING

from course.api import (
    Arena,
    Failure,
    Feedback,
    Grader,
    Location,
    OurFault,
    Process,
    ProcessView,
    Recording,
    Sources,
    Stream,
    calls,
    expect_clean_interrupt,
    expect_compiled,
    expect_executable,
    expect_launch_file,
    expect_launch_interrupt,
    expect_launch_parameter,
    expect_launched,
    expect_launched_node,
    expect_mode,
    expect_running,
    launch_file,
    listed,
    named,
    native_answer,
    nearest,
    places_of,
    replace,
    text_places,
)
from lib.following import same
from lib.joints import (
    expect_alike,
    expect_follows_wave,
    expect_rate,
    expect_steps,
    expect_values,
    expect_width,
    told,
)
from lib.waves import fit_wave

if TYPE_CHECKING:
    from course.api import Listener

PROBES = Path(__file__).with_name("probes")
PACKAGE = "sas_robot_driver_myrobot"
EXECUTABLE = f"{PACKAGE}_node"
IN_CPP = f"sas_tutorial_workspace/src/{PACKAGE}"
DRIVER_CPP, NODE_CPP = f"{IN_CPP}/src/{PACKAGE}.cpp", f"{IN_CPP}/src/{EXECUTABLE}.cpp"
HEADERS = (f"include/{PACKAGE}", "include", "src")  # where the class may be declared
IN_PYTHON = f"{PACKAGE}_python"
PYTHON_NODE = "myrobot_node"
LAUNCH_FILE = "real_robot_launch.py"
SCRIPT = "joint_interface_example.py"
SCRIPT_FILE = f"{IN_CPP}/scripts/{SCRIPT}"

JOINTS = 6
STATES, LEAST, GREATEST = "get/joint_states", "get/joint_positions_min", "get/joint_positions_max"
TARGETS = "set/target_joint_positions"
JOINT_STATE = "sensor_msgs/msg/JointState"
DOUBLES, INTEGERS = "std_msgs/msg/Float64MultiArray", "std_msgs/msg/Int32MultiArray"
TOLD = {STATES: JOINT_STATE, LEAST: DOUBLES, GREATEST: DOUBLES, "get/home_states": INTEGERS}
HEARD = {
    TARGETS: DOUBLES,
    "set/target_joint_velocities": DOUBLES,
    "set/target_joint_forces": DOUBLES,
    "set/homing_signal": INTEGERS,
    "set/clear_positions": INTEGERS,
}


@dataclass(frozen=True)
class Robot:
    """A robot as the scenario starts it. Its limits are in degrees. period: of its loop, in s."""

    name: str
    least: tuple[float, ...]
    greatest: tuple[float, ...]
    period: float

    def topic(self, name: str) -> str:
        return f"/{self.name}/{name}"

    @property
    def parameters(self) -> dict[str, str | float | list[float]]:
        least, greatest = (list(map(float, limits)) for limits in (self.least, self.greatest))
        limits = {"joint_limits_min": least, "joint_limits_max": greatest}
        return {"ip": "127.0.0.1", **limits, "thread_sampling_time_sec": self.period}


# Names, limits, and periods that differ from the lesson's, to reveal hard-coded values.
LEFT = Robot("left_arm", (-95.0, -96, -97, -98, -99, -185), (101.0, 102, 103, 104, 105, 190), 0.002)
RIGHT = replace(LEFT, name="right_arm", period=0.004)
MYROBOT = Robot("myrobot_1", (*[-360.0] * 5, -720), (*[360.0] * 5, 720), 0.002)
WRITING = replace(LEFT, name="writing_arm", period=0.01)
DRAWING = replace(WRITING, name="drawing_arm", period=0.02)

# Starts the driver of a robot; the text is what the recording calls the program.
Start = Callable[[Robot, str], Process | None]

STEPS = tuple(tuple(0.1 * step + 0.02 * joint for joint in range(JOINTS)) for step in range(1, 11))
STEP_TIME = 0.06
WAVE, COMMANDS = 1.0, 0.01  # Hz, and s between two targets
# What a driver's source may use: `deg2rad`, parameters, or the driver's node are not mistakes there.
LIBRARIES = ("sas_core", "sas_robot_driver", "dqrobotics", "rclcpp", "rcutils")
# What RobotDriverROS logs before each step and when one fails, and the functions that it calls then.
STEP = re.compile(r"::Robot driver: ([a-z ]+)$")
FAILED = re.compile(r"::Robot driver: (?P<step>[a-z ]+) failed: (?P<error>.*)")
PARAMETER = re.compile(r"parameter '(?P<name>\w+)'")
FAILING = {
    "connect": r"::connect\s*\(",
    "initialize": r"::initialize\s*\(",
    "control loop": r"::(?:get|set_target)_joint_positions\s*\(",
}
# What must appear at the end: calls, as the control loop logs them, or texts of a driver without that loop.
CALLS, WORDS = ("deinitialize", "disconnect"), ("Motor off", "Disconnected")
WRONG = "a target of five elements"
AGAIN = "again, until it gets a target of five elements"

driver = Grader("31-driver", builds=2)
launch = Grader("31-launch")
client = Grader("31-client")
in_python = Grader("31-driver-python")


# Acting on a driver ----------------------------------------------------------------------------------


def two_lives(arena: Arena, robots: tuple[Robot, Robot], name: str, start: Start) -> None:
    """Watch the first robot's driver, then end the second robot's driver with a wrong target."""
    with arena.fresh():
        heard = watch(arena, robots[0], lambda: start(robots[0], name))
    if heard:
        with arena.fresh():
            end_with_a_wrong_target(arena, robots[1], lambda: start(robots[1], AGAIN))


def watch(arena: Arena, robot: Robot, start: Callable[[], Process | None]) -> bool:
    """Start the robot's driver, command it, and press Ctrl+C. Return whether its joints were heard."""
    with arena.lateness():
        states, node = hear(arena, robot, start)
        if node and states.count:
            command(arena, robot, states, node)
    arena.interrupt(node)
    return states.count > 0


def command(arena: Arena, robot: Robot, states: Listener, node: Process) -> None:
    """Listen for two seconds, then command steps and a sine."""
    targets = arena.ros.publisher(robot.topic(TARGETS), DOUBLES)
    more(arena, states, node, 2 / robot.period)
    if not arena.until(lambda: targets.matched, timeout=3, while_running=node):
        return
    for target in STEPS:
        targets.publish(data=list(target))
        more(arena, states, node, STEP_TIME / robot.period + 3)
    for number in arena.ticks(COMMANDS, 250):
        if not node.running:
            return
        targets.publish(data=wave(number * COMMANDS))
    more(arena, states, node, STEP_TIME / robot.period)


def hear(arena: Arena, robot: Robot, start: Callable[[], Process | None]) -> tuple[Listener, Process | None]:
    """Start the driver, and wait until its joints and their limits have been heard."""
    states = arena.ros.subscribe(robot.topic(STATES), JOINT_STATE)
    limits = [arena.ros.subscribe(robot.topic(name), DOUBLES) for name in (LEAST, GREATEST)]
    node = start()
    if node and arena.until(lambda: arena.ros.graph.nodes, timeout=15, while_running=node):
        arena.until(lambda: states.count, timeout=8, while_running=node)
        if states.count:
            arena.until(lambda: all(one.count for one in limits), timeout=2, while_running=node)
    for one in limits:  # they are the same in each run
        one.close()
    return states, node


def more(arena: Arena, states: Listener, node: Process, messages: float) -> None:
    """Wait for this many more messages, but not for a driver that is much slower."""
    wanted = states.count + round(messages)
    arena.until(lambda: states.count >= wanted, timeout=3, while_running=node)


def wave(t: float) -> list[float]:
    """A different motion for each joint, around a different position, so that swapped joints show."""
    turn = math.tau * WAVE * t
    return [0.1 * joint + 0.2 * (1 + 0.2 * joint) * math.sin(turn + 0.3 * joint) for joint in range(JOINTS)]


def end_with_a_wrong_target(arena: Arena, robot: Robot, start: Callable[[], Process | None]) -> None:
    """Run the driver again, and end it with a target of five elements."""
    with arena.lateness():
        states, node = hear(arena, robot, start)
        targets = arena.ros.publisher(robot.topic(TARGETS), DOUBLES)
        ready = bool(node and states.count) and arena.until(
            lambda: targets.matched, timeout=3, while_running=node
        )
        if node and ready:
            more(arena, states, node, 1.2 / robot.period)
    if node and ready:
        arena.mark(WRONG)
        targets.publish(data=[0.1] * (JOINTS - 1))
        arena.until(lambda: False, timeout=6, while_running=node)
    arena.interrupt(node)


# What is expected of a driver, in C++ or in Python ---------------------------------------------------


def states_of(recording: Recording, robot: Robot) -> Stream:
    return recording.stream(robot.topic(STATES), "position")


def commands_of(recording: Recording, robot: Robot) -> tuple[Stream, Stream]:
    """The steps and the sine that the scenario commanded."""
    sent = recording.sent_stream(robot.topic(TARGETS), "data")
    if len(sent) <= len(STEPS):
        return sent, sent.between(math.inf)
    begin = sent.times[len(STEPS)]
    return sent.between(end=math.nextafter(begin, 0)), sent.between(begin)


def expect_topics(recording: Recording, robot: Robot, prefix: str, missing: str) -> None:
    """Expect exactly these topics and types. prefix, missing: advice if a name is different or missing."""
    seen = {
        kind: {e.topic: e.type for e in recording.seen_endpoints() if e.kind == kind}
        for kind in ("publisher", "subscription")
    }
    for kind, verb, wanted in (
        ("publisher", "publishes on", TOLD),
        ("subscription", "subscribes to", HEARD),
    ):
        topics = {robot.topic(name): type_name for name, type_name in wanted.items()}
        for topic, type_name in topics.items():
            expect_topic(recording.sources, seen[kind], topic, type_name, robot, verb, prefix, missing)
        more = sorted(t for t in seen[kind].keys() - topics.keys() if t.startswith(f"/{robot.name}/"))
        if more:
            raise Failure(
                Feedback(
                    summary=f"The driver also {verb} `{more[0]}`, which other drivers don't have.",
                    expected=listed(sorted(topics)),
                    seen=listed(more),
                    advice="Remove it. All robots must have the same topics.",
                )
            )


def expect_topic(
    sources: Sources,
    seen: dict[str, str],
    topic: str,
    type_name: str,
    robot: Robot,
    verb: str,
    prefix: str,
    missing: str,
) -> None:
    if topic in seen:
        if seen[topic] == type_name:
            return
        raise Failure(
            Feedback(
                summary=f"The topic `{topic}` has the wrong type, `{seen[topic]}`.",
                expected=type_name,
                seen=seen[topic],
                where=named(sources, seen[topic])[:1],
                advice=f"Use `{type_name.split('/')[-1]}` from {type_name.split('/')[0]}.",
            )
        )
    name = topic.removeprefix(f"/{robot.name}/")
    other = next((one for one in sorted(seen) if one.endswith(f"/{name}")), None)
    close = other or nearest(topic, seen)
    raise Failure(
        Feedback(
            summary=f"The driver {verb} `{close}`, not `{topic}`."
            if close
            else f"The driver has no topic `{topic}`.",
            expected=topic,
            seen=close or listed(sorted(seen), "no topics"),
            where=named(sources, close)[:1] if close else (),
            advice=prefix if other else missing,
        )
    )


def expect_limits(recording: Recording, robot: Robot, advice: str, where: Iterable[Location] = ()) -> None:
    for name, degrees, which in ((LEAST, robot.least, "lower"), (GREATEST, robot.greatest, "upper")):
        seen = recording.stream(robot.topic(name), "data")
        expect_width(seen, JOINTS, advice=advice, where=tuple(where))
        wanted = [math.radians(limit) for limit in degrees]
        what = f"{which} limits"
        other = robot.least if degrees is robot.greatest else robot.greatest
        if same(tuple(seen.rows[0]), tuple(map(math.radians, other))):
            advice = "Swap the lower and upper limits: the lower limits come first."
            where = at(recording, r"deg2rad\b.*joint_limits_m(?:in|ax)|joint_limits\s*=", NODE_CPP)
        expect_values(seen.name, seen.rows[0], wanted, what=what, advice=advice, where=tuple(where))


def expect_zeros(recording: Recording, robot: Robot, advice: str, where: Iterable[Location] = ()) -> None:
    """Expect six joints at zero until the first target."""
    first = next(iter(recording.sent_stream(robot.topic(TARGETS), "data").times), math.inf)
    states = states_of(recording, robot).between(end=first)
    expect_width(states, JOINTS, advice=advice, where=tuple(where))
    other = next((row for row in states.rows if any(row)), None)
    if other:
        raise Failure(
            Feedback(
                summary="The joints are not at zero before the first target.",
                expected=told([0.0] * JOINTS),
                seen=told(other),
                where=tuple(where),
                advice=advice,
            )
        )


def expect_step_and_wave(
    recording: Recording, robot: Robot, kind: str, advice: str, where: Iterable[Location] = ()
) -> None:
    """kind: "steps" or "wave". A loop receives a target in one cycle, and publishes it in the next."""
    steps, sine = commands_of(recording, robot)
    states = states_of(recording, robot)
    if len(states.widths) > 1:
        remedy = "Replace the old positions with those of the target. `+=` or `append` makes the list longer."
        expect_width(states, JOINTS, advice=remedy)
    if kind == "steps":
        within = max(0.010, 2.5 * robot.period)
        expect_steps(recording, steps, states, within=within, advice=advice, where=tuple(where))
        return
    within = 0.03 + 2 * robot.period
    states = states.between(sine.times[0] + 0.2, sine.times[-1]) if len(sine) else sine
    expect_no_jump(sine, states, advice, tuple(where))
    expect_follows_wave(recording, sine, states, WAVE, within=within, advice=advice, where=tuple(where))


def expect_no_jump(sine: Stream, states: Stream, advice: str, where: tuple[Location, ...]) -> None:
    """Expect that no joint jumps away from its commands, which a busy machine can't cause.

    The first rows may still show an earlier target if the machine was busy.
    """
    for joint in range(JOINTS if len(sine) and states.widths == (JOINTS,) else 0):
        least, greatest = min(sine.column(joint)), max(sine.column(joint))
        room = 0.1 * (greatest - least)
        outside = [(not least - room <= x <= greatest + room, x) for x in states.column(joint)]
        far = next((x for out, x in dropwhile(itemgetter(0), outside) if out), None)
        if far is not None:
            raise Failure(
                Feedback(
                    summary=f"Joint {joint + 1} moves to a position that was not commanded.",
                    expected=f"positions from {least:.3g} to {greatest:.3g} rad",
                    seen=f"{far:.3g} rad",
                    where=where,
                    advice=advice,
                )
            )


def expect_order(view: ProcessView, after: float, what: str, advice: str, ends: tuple[str, str]) -> None:
    """Expect that after that moment, the first of `ends` appeared on the terminal, then the second.

    If a control loop logs no calls at all, they are invisible, so it is enough that it ends.
    """
    if ends == CALLS and not any(STEP.search(line.text) for line in view.lines):
        return
    said = [line.text for line in view.lines if line.t >= after]
    first, second = (next((n for n, text in enumerate(said) if end in text), None) for end in ends)
    if first is not None and second is not None and first < second:
        return
    if first is None and second is None:
        summary = f"After {what}, the driver ends without `{ends[0]}` or `{ends[1]}`: the motor stays on."
    elif first is None:
        summary = f"After {what}, there is a `{ends[1]}` but no `{ends[0]}`: the motor stays on."
    elif second is None:
        summary = f"After {what}, there is a `{ends[0]}` but no `{ends[1]}`: the robot stays connected."
    else:
        summary = f"After {what}, `{ends[1]}` comes before `{ends[0]}`."
    raise Failure(
        Feedback(
            summary=summary,
            expected=f"`{ends[0]}`, then `{ends[1]}`",
            seen="; ".join(said[-3:]) or "nothing in the terminal",
            advice=advice,
        )
    )


def expect_end_by_a_wrong_target(
    recording: Recording, process: str, advice: str, order: str, ends: tuple[str, str]
) -> None:
    """Expect that a target of five elements ends the driver in order, with an error in its log."""
    expect_executable(recording, process)
    view, mark = recording.process(process), recording.marked(WRONG)
    if mark is None:
        raise Failure(
            Feedback(
                summary="When the driver is started a second time, it does not accept a target.",
                advice="Start it twice yourself. Does the first run leave something behind?",
                details=view.text[-6:],
            )
        )
    if view.ended_by_itself is None:
        raise Failure(
            Feedback(
                summary="The driver has six joints, but a target with five elements does not stop it.",
                expected="the driver ends, with an error in its log",
                seen="the driver continues to run",
                where=text_places(recording.sources, "::set_target_joint_positions(")[:1]
                or text_places(recording.sources, "set_target_joint_positions(")[-1:],
                advice=advice,
            )
        )
    expect_order(view, mark.t, WRONG, order, ends)
    logged = any(line.level in ("ERROR", "FATAL") for line in recording.log if line.t >= mark.t)
    if not logged and not any("[ERROR]" in line.text or "[FATAL]" in line.text for line in view.lines):
        raise Failure(
            Feedback(
                summary="A target of five elements ends the driver, but the driver does not log an error.",
                expected="a message at level ERROR",
                seen="; ".join(view.text[-3:]),
                advice=advice,
            )
        )


# 31-driver -------------------------------------------------------------------------------------------


@driver.scenario
def class_and_node(arena: Arena) -> None:
    """Call the class's functions, then run the node twice."""
    arena.cpp.require_libraries("Eigen3")
    program = arena.cpp.compile(
        "class",
        DRIVER_CPP,
        *more_files(arena),
        ours=PROBES / "ch31_driver.cpp",
        options=(*(f"-I{IN_CPP}/{folder}" for folder in HEADERS), *arena.cpp.ros_options(*LIBRARIES)),
        sanitized=False,
    )
    for question in ("life", "early", "wrong", "ends"):
        arena.cpp.ask(program, question, name=question, timeout=10, env=arena.cpp.ros_libraries)

    def start(robot: Robot, name: str) -> Process | None:
        return arena.run(PACKAGE, EXECUTABLE, params=robot.parameters, node_name=robot.name, name=name)

    two_lives(arena, (LEFT, RIGHT), EXECUTABLE, start)


def more_files(arena: Arena) -> list[str]:
    """The other files in the package's `src` that the class may need: all that lack a `main`."""
    listed = arena.files.text(f"{IN_CPP}/CMakeLists.txt") or ""
    files = arena.files.matching(f"{IN_CPP}/src/*.cpp")
    others = (file for file in files if file not in (DRIVER_CPP, NODE_CPP) and Path(file).name in listed)
    return [file for file in others if not re.search(r"\bmain\s*\(", arena.files.text(file) or "")]


def expect_begun(recording: Recording, process: str) -> None:
    """Expect that `connect` and `initialize` threw nothing in this run."""
    for name in ("connect", "initialize"):
        where = at(recording, rf"::{name}\s*\(", DRIVER_CPP)
        answer = native_answer(recording, name, f"{name}()", process, where=where[0])
        if answer.error is None:
            continue
        raise Failure(
            Feedback(
                summary=f"`{name}()` throws, although nothing is wrong with the robot.",
                expected="no exception",
                seen=answer.error[:150],
                where=where,
                advice=f"Find out what throws in `{name}()`. This robot can always be reached and started.",
            )
        )


@driver.check("usable", "another program can use the class")
def usable(recording: Recording) -> None:
    expect_compiled(recording, "class")


@driver.check("connected", "after `connect`, it has six zeros and reaches each target", needs="usable")
def connected(recording: Recording) -> None:
    where = at(recording, r"::connect\s*\(", DRIVER_CPP)
    expect_begun(recording, "life")
    for question, what, wanted, advice in (
        ("zeros", "get_joint_positions()", [0.0] * JOINTS, "Set the positions to six zeros in `connect`."),
        (
            "follows",
            "get_joint_positions()",
            [0.25 * (joint + 1) for joint in range(JOINTS)],
            "Store all six numbers of the target in `set_target_joint_positions`.",
        ),
    ):
        answer = native_answer(recording, question, what, "life", where=where[0])
        if answer.error is None and answer.value == wanted:
            continue
        raise Failure(
            Feedback(
                summary=f"`{what}` does not return {told(wanted)}."
                if answer.error is None
                else f"The driver throws although it is connected: {answer.error[:80]}",
                expected=told(wanted),
                seen=told(answer.value) if answer.error is None else answer.error[:120],
                where=where,
                advice=advice,
            )
        )


@driver.check("throws", "it throws if it can't do what it is asked to do", points=2, needs="usable")
def throws(recording: Recording) -> None:
    for question, process, what, name in (
        ("early", "early", "get_joint_positions()` before `connect()`", "get_joint_positions"),
        ("late", "ends", "get_joint_positions()` after `disconnect()`", "disconnect"),
        ("five", "wrong", "set_target_joint_positions` with five elements", "set_target_joint_positions"),
        ("seven", "wrong", "set_target_joint_positions` with seven elements", "set_target_joint_positions"),
    ):
        if process != "early":
            expect_begun(recording, process)
        where = at(recording, rf"::{name}\s*\(", DRIVER_CPP)
        answer = native_answer(recording, question, f"{name}()", process, where=where[0])
        if answer.error is not None:
            continue
        raise Failure(
            Feedback(
                summary=f"`{what} does not throw.",
                expected="std::runtime_error",
                seen=f"it returns {told(answer.value)}" if answer.value else "it returns",
                where=where,
                advice="In `disconnect`, clear the positions. Without a connection, the robot has none."
                if question == "late"
                else "Check for this first, and `throw std::runtime_error(...)` with a text that says why.",
            )
        )


@driver.check("peaceful", "`deinitialize` and `disconnect` never throw", points=2, needs="usable")
def peaceful(recording: Recording) -> None:
    for name in ("deinitialize", "disconnect"):
        where = at(recording, rf"::{name}\s*\(", DRIVER_CPP)
        for when in (" at once", "", " again"):
            if not when:
                expect_begun(recording, "ends")
            answer = native_answer(recording, name + when, f"{name}()", "ends", where=where[0])
            if answer.error is None:
                continue
            what = {" at once": "called before `connect()`", " again": "called twice"}
            raise Failure(
                Feedback(
                    summary=f"`{name}()` throws when it is {what.get(when, 'called normally')}.",
                    expected="no exception, no matter what happened before",
                    seen=answer.error[:150],
                    where=where,
                    advice="Don't call anything that may throw: nothing would catch the exception.",
                )
            )


@driver.check("starts", "the program starts with its parameters and keeps running")
def starts(recording: Recording) -> None:
    expect_executable(recording, EXECUTABLE)
    view = recording.process(EXECUTABLE)
    ended = view.ended_by_itself
    if ended and ended.signal is None and (failure := why_ended(recording, view)):
        raise Failure(failure)
    expect_running(recording, EXECUTABLE)
    until = view.interrupted_at or math.inf
    steps = [found[1] for line in view.lines if line.t < until and (found := STEP.search(line.text))]
    if steps[-1:] in (["connect"], ["initialize"]) and not states_of(recording, LEFT).times:
        raise Failure(
            Feedback(
                summary=f"`{steps[-1]}()` of the driver never returns, so the control loop never starts.",
                expected="it returns immediately",
                seen="it was still running at the end",
                where=at(recording, rf"::{steps[-1]}\s*\("),
                advice="Look for a loop that never ends. Only `control_loop()` contains a driver's loop.",
            )
        )


def why_ended(recording: Recording, view: ProcessView) -> Feedback | None:
    """Why the driver ended early, by its own message. None if C++ itself ended it."""
    if any("terminate called" in text or "error while loading" in text for text in view.text):
        return None
    said = next((text for text in view.text if "[ERROR]" in text or "[FATAL]" in text), None)
    failed = FAILED.search(said) if said else None
    where = at(recording, FAILING[failed["step"]]) if failed and failed["step"] in FAILING else ()
    advice = f"Find out what throws this in `{failed['step']}()`." if failed else "Start with this error."
    if failed and failed["step"] == "control loop":
        advice = "Find out what throws this in `get_joint_positions` or `set_target_joint_positions`."
    asked = PARAMETER.search(said or "")
    near = nearest(asked["name"], set(LEFT.parameters) - {asked["name"]}) if asked else None
    if asked and near and asked["name"] not in LEFT.parameters:
        where = text_places(recording.sources, f'"{asked["name"]}"')[:1]
        advice = f"Change the name of the parameter `{asked['name']}`: it is called `{near}`."
    if said is None:
        where = at(recording, r"\bcontrol_loop\s*\(|\bmain\s*\(", NODE_CPP)
        advice = (
            "Call `control_loop()` of the `RobotDriverROS`, which runs the driver until Ctrl+C. Set the "
            "flag only in the handler."
        )
    return Feedback(
        summary="The driver ends on its own because of an error."
        if said
        else "The driver ends on its own, without an error message.",
        expected="it runs until Ctrl+C",
        seen=(failed["error"] if failed else said or "no error")[:200],
        where=where,
        advice=advice,
        details=view.text[-6:],
    )


@driver.check("topics", "it has the topics of a driver, which start with the node's name", needs="starts")
def topics(recording: Recording) -> None:
    prefix = "Use the node's name: `configuration.robot_driver_provider_prefix = node->get_name();`"
    missing = "Create a `sas::RobotDriverROS`, which has all these topics, and call its `control_loop()`."
    expect_topics(recording, LEFT, prefix, missing)


@driver.check("limits", "the limits are those in the parameters, in radians", needs="topics")
def limits(recording: Recording) -> None:
    advice = (
        "Convert the parameters with `deg2rad`, and pass them to the configuration and to `joint_limits_`."
    )
    expect_limits(recording, LEFT, advice, at(recording, r"\bjoint_limits_?\s*="))


@driver.check("joints", "it has six joints, which start at zero", needs="topics")
def joints(recording: Recording) -> None:
    expect_zeros(
        recording, LEFT, "In `connect`, set the positions to six zeros.", at(recording, r"::connect\s*\(")
    )


@driver.check("rate", "the joint positions come at the rate in the parameter", points=2, needs="topics")
def rate(recording: Recording) -> None:
    where = at(recording, r"\bthread_sampling_time_sec\b", NODE_CPP)
    advice = "Pass the parameter `thread_sampling_time_sec` to the `RobotDriverROS` configuration. "
    for robot in (LEFT, RIGHT):
        states = states_of(recording, robot)
        if robot is RIGHT and recording.marked(WRONG) is None:
            return
        expect_rate(
            recording,
            states,
            1 / robot.period,
            advice=advice + "None of the driver's functions may be slow.",
            where=where,
        )


@driver.check("step", "a target takes effect within 10 ms", points=2, needs="joints")
def step(recording: Recording) -> None:
    advice = "Move the robot right away in `set_target_joint_positions`, without waiting."
    where = at(recording, r"::set_target_joint_positions\s*\(")
    expect_step_and_wave(recording, LEFT, "steps", advice, where)


@driver.check("wave", "the joints follow a sine exactly", points=2, needs="joints")
def follows_wave(recording: Recording) -> None:
    advice = "Return all six numbers of the last target from `get_joint_positions`, in their order."
    where = at(recording, r"::(?:set_target|get)_joint_positions\s*\(")
    expect_step_and_wave(recording, LEFT, "wave", advice, where)


@driver.check("wrong_target", "a target of five elements ends it cleanly", points=2, needs="joints")
def wrong_target(recording: Recording) -> None:
    advice = "Throw in `set_target_joint_positions`, and don't catch it. `control_loop()` does the rest."
    order = "Let `control_loop()` return. It always calls `deinitialize` and `disconnect`."
    expect_end_by_a_wrong_target(recording, AGAIN, advice, order, CALLS)


@driver.check("interrupt", "Ctrl+C ends it cleanly: deinitialize, then disconnect", points=2, needs="starts")
def interrupt(recording: Recording) -> None:
    expect_clean_interrupt(recording, EXECUTABLE)
    view = recording.process(EXECUTABLE)
    asked = view.interrupted_at or 0.0
    if view.exited and view.exited.signal == signal.SIGINT:
        raise Failure(
            Feedback(
                summary="Ctrl+C kills the driver immediately, so nothing switches the motor off.",
                expected="`deinitialize`, then `disconnect`",
                seen="it was ended by the signal SIGINT",
                where=at(recording, r"\bmain\s*\(", NODE_CPP),
                advice="In `main`, call `std::signal(SIGINT, ...)` before `rclcpp::init`. Pass it a function "
                "that sets the flag of `RobotDriverROS`.",
            )
        )
    order = "Let `control_loop()` return. The handler must only set its flag."
    expect_order(view, asked, "Ctrl+C", order, CALLS)


def at(recording: Recording, pattern: str, otherwise: str = DRIVER_CPP) -> tuple[Location, ...]:
    """The places in the learner's C++ code that match, or else the file that should contain one."""
    return tuple(dict.fromkeys(places_of(recording.sources, pattern)))[:2] or (Location(otherwise),)


# 31-launch -------------------------------------------------------------------------------------------


@launch.scenario
def one_launch(arena: Arena) -> None:
    asked = arena.ros.parameters(f"/{MYROBOT.name}")
    with arena.lateness():
        states, launched = hear(arena, MYROBOT, lambda: arena.launch(PACKAGE, LAUNCH_FILE))
        if launched and states.count:
            more(arena, states, launched, 2 / MYROBOT.period)
    if launched and states.count:
        arena.until(lambda: asked.available, timeout=3, while_running=launched)
        answered = asked.get("ip")
        arena.until(lambda: all(one.done for one in answered), timeout=6, while_running=launched)
    arena.interrupt(launched)


@launch.check("launches", "`ros2 launch` starts the launch file, which keeps running")
def launches(recording: Recording) -> None:
    expect_launch_file(recording, PACKAGE, LAUNCH_FILE)
    expect_launched(recording, LAUNCH_FILE)


@launch.check("node_name", f"the node's name is /{MYROBOT.name}", needs="launches")
def node_name(recording: Recording) -> None:
    expect_launched_node(recording, LAUNCH_FILE, f"/{MYROBOT.name}")


@launch.check("launched_topics", "it has all the topics of a driver", needs="node_name")
def launched_topics(recording: Recording) -> None:
    advice = "Start exactly one node in the launch file: the driver from `31-driver`."
    expect_topics(recording, MYROBOT, advice, advice)


@launch.check(
    "launched_limits", "the limits are ±360 degrees, and ±720 for the last joint", needs="node_name"
)
def launched_limits(recording: Recording) -> None:
    own = launch_file(recording, LAUNCH_FILE)
    where = (*named(own, "joint_limits_min"), *named(own, "joint_limits_max"))
    advice = "Write 360.0 five times, then 720.0, in degrees. In `joint_limits_min`, they are negative."
    expect_limits(recording, MYROBOT, advice, where)


@launch.check("launched_rate", "the joint positions come at 500 Hz", points=2, needs="node_name")
def launched_rate(recording: Recording) -> None:
    where = named(launch_file(recording, LAUNCH_FILE), "thread_sampling_time_sec")
    advice = "Set `'thread_sampling_time_sec': 0.002` in the `parameters`, for 500 times per second."
    states = states_of(recording, MYROBOT)
    expect_rate(recording, states, 1 / MYROBOT.period, advice=advice, where=where)


@launch.check("ip", "the robot's address is 127.0.0.1", needs="node_name")
def ip(recording: Recording) -> None:
    expect_launch_parameter(recording, LAUNCH_FILE, f"/{MYROBOT.name}", "ip", "127.0.0.1")


@launch.check("launched_end", "one Ctrl+C ends everything in order", points=2, needs="launches")
def launched_end(recording: Recording) -> None:
    expect_launch_interrupt(recording, LAUNCH_FILE)
    view = recording.launched(LAUNCH_FILE)
    asked = view.main.interrupted_at or 0.0
    order = "Run `ros2course check 31-driver` first: it checks this, too."
    for program in view.processes.values():
        expect_order(program, asked, "Ctrl+C", order, CALLS)


# 31-client -------------------------------------------------------------------------------------------

# The sine that the script sends: 10 degrees, and the cycles of the loop in a period.
SWING, CYCLES = math.radians(10), math.tau * 50 * math.pi
ENOUGH = 520


@client.scenario
def a_robot_to_move(arena: Arena) -> None:
    """Run our own robot, and half a swing of the script."""
    targets = arena.ros.subscribe(MYROBOT.topic(TARGETS), DOUBLES)
    states = arena.ros.subscribe(MYROBOT.topic(STATES), JOINT_STATE)
    robot = arena.play_along(PROBES / "ch31_robot.py", MYROBOT.name, name="robot")
    if not arena.until(lambda: states.count, timeout=20, while_running=robot):
        raise OurFault("the grader's robot did not start")
    with arena.lateness():
        script = arena.run(PACKAGE, SCRIPT)
        arena.until(lambda: targets.count, timeout=20, while_running=script)
        if targets.count:
            arena.until(lambda: targets.count >= ENOUGH, timeout=8, while_running=script)
    arena.interrupt(script, grace=8.0)  # at load 16, it took 3.5 s to end
    robot.close()


@client.check("script", "the script can be executed", needs=())
def script(recording: Recording) -> None:
    # A submission may lose the file mode on its way, and CMake can set it.
    if recording.local and "OWNER_EXECUTE" not in recording.sources.files.get(f"{IN_CPP}/CMakeLists.txt", ""):
        expect_mode(
            recording,
            SCRIPT_FILE,
            has=stat.S_IXUSR,
            summary="The script is not executable: with `--symlink-install`, `ros2 run` does not find it.",
            advice=f"Run `chmod +x ~/{SCRIPT_FILE}`.",
        )
    first = recording.home.file(SCRIPT_FILE).lines[:1]
    if not first or not re.match(r"#!\s*/\S*(?:python3|env python3)", first[0]):
        raise Failure(
            Feedback(
                summary="The script's first line does not say which program runs it.",
                expected="#!/usr/bin/python3",
                seen=(first or ("an empty file",))[0][:100],
                where=(Location(SCRIPT_FILE, 1),),
                advice="Make `#!/usr/bin/python3` the very first line.",
            )
        )


@client.check("runs", "the script is installed and keeps running", needs=("builds", "script"))
def runs(recording: Recording) -> None:
    missing = recording.missing_executable(SCRIPT)
    if missing:
        raise Failure(
            Feedback(
                summary=f"`ros2 run` does not find `{SCRIPT}`, because CMakeLists.txt does not install it.",
                expected=f"installed in the folder lib/{PACKAGE}",
                seen=f"installed: {listed(missing.available)}",
                where=(Location(f"{IN_CPP}/CMakeLists.txt"),),
                advice=f"Add `install(PROGRAMS scripts/{SCRIPT} DESTINATION lib/${{PROJECT_NAME}})`.",
            )
        )
    expect_running(only_script(recording), SCRIPT)


@client.check("sends", f"it sends targets to the robot {MYROBOT.name}", needs="runs")
def sends(recording: Recording) -> None:
    if recording.messages(MYROBOT.topic(TARGETS)):
        return
    sources = only_script(recording).sources
    right = MYROBOT.topic(TARGETS)
    topics = {e.topic for e in recording.seen_endpoints() if e.kind == "publisher"} - {right}
    other = next((topic for topic in sorted(topics) if topic.endswith(f"/{TARGETS}")), None)
    if other:
        raise Failure(
            Feedback(
                summary=f"The client sends targets to `{other.removesuffix(f'/{TARGETS}')}`, "
                f"but the robot's name is `/{MYROBOT.name}`.",
                expected=MYROBOT.topic(TARGETS),
                seen=other,
                where=places(sources, "RobotDriverClient"),
                advice=f"Use the robot's name: `RobotDriverClient(node, '{MYROBOT.name}')`.",
            )
        )
    spins = calls(sources, "rclcpp_spin_some")
    raise Failure(
        Feedback(
            summary="The script sends no targets: nothing spins the node, so the client is never enabled."
            if len(spins) < 2
            else "The script sends no targets.",
            expected=f"targets on {MYROBOT.topic(TARGETS)}",
            seen="none",
            where=places(sources, "is_enabled"),
            advice="Call `rclcpp_spin_some(node)` in the loop that waits for `is_enabled()`."
            if len(spins) < 2
            else "Once the client is enabled, call `send_target_joint_positions` in each cycle.",
        )
    )


@client.check(
    "swing", "the targets swing by ten degrees around the first joint positions", points=2, needs="sends"
)
def swing(recording: Recording) -> None:
    targets = recording.stream(MYROBOT.topic(TARGETS), "data")
    sources = only_script(recording).sources
    where = places(sources, "send_target_joint_positions")
    expect_width(targets, JOINTS, advice="Send one number for each joint.", where=where)
    begin = recording.stream(MYROBOT.topic(STATES), "position").rows[0]
    for joint in range(JOINTS):
        made = fit_wave(range(len(targets)), targets.column(joint), 1 / CYCLES)
        if made is None:
            raise Failure(
                Feedback(
                    summary=f"The script sends only {len(targets)} targets, too few for a swing.",
                    where=where,
                    advice="Send a target in each cycle of the loop.",
                )
            )
        around = made.offset - begin[joint]
        if abs(made.amplitude - math.degrees(SWING)) < 0.5 and abs(around) < 1.0:
            raise Failure(
                Feedback(
                    summary="The targets are in degrees, but the robot expects radians.",
                    expected=f"a swing of {SWING:.4f} rad",
                    seen=f"a swing of {made.amplitude:.1f}",
                    where=where,
                    advice="Write `deg2rad(10 * sin(...))`. `deg2rad` comes from `dqrobotics.utils.DQ_Math`.",
                )
            )
        multiplied = fit_wave(range(len(targets)), targets.column(joint), math.pi / math.tau / 50)
        if multiplied and abs(multiplied.amplitude - SWING) < 0.05 * SWING > multiplied.rest:
            raise Failure(
                Feedback(
                    summary="The targets swing too fast: `i` is divided by 50 and then multiplied by pi.",
                    expected=f"{CYCLES:.0f} cycles per period",
                    seen="100 cycles per period",
                    where=places(sources, "sin")[:1] or where,
                    advice="Put parentheses around the product: `i / (50.0 * math.pi)`.",
                )
            )
        amplitude, rest = made.amplitude, made.rest
        if floods(targets):
            amplitude, rest = max(abs(value - begin[joint]) for value in targets.column(joint)), 0.0
        if abs(amplitude - SWING) > 0.05 * SWING or rest > 0.05 * SWING:
            raise Failure(
                Feedback(
                    summary="The targets do not follow the sine in the task.",
                    expected=f"10 degrees ({SWING:.4f} rad), {CYCLES:.0f} cycles per period",
                    seen=f"joint {joint + 1} from {told([min(targets.column(joint))])} to "
                    f"{told([max(targets.column(joint))])} in {len(targets)} cycles",
                    where=where,
                    advice="In cycle `i`, send `q0 + deg2rad(10 * sin(i / (50 * pi)))`. Read `q0` once, "
                    "before the loop.",
                )
            )
        if not floods(targets) and abs(around) > 0.02:
            raise Failure(
                Feedback(
                    summary="The targets do not swing around the joints' initial positions.",
                    expected=f"joint {joint + 1} around {begin[joint]:.3g} rad",
                    seen=f"around {made.offset:.3g} rad",
                    where=where,
                    advice="Read `q0 = robot.get_joint_positions()` once, before the loop. Then add to it.",
                )
            )


def floods(targets: Stream) -> bool:
    """Whether they come so fast that some may be lost, so that nobody can count the cycles."""
    return len(targets) > 2 * 100 * (targets.times[-1] - targets.times[0])


@client.check("alike", "all six joints move the same way", needs="sends")
def joints_alike(recording: Recording) -> None:
    where = places(only_script(recording).sources, "send_target_joint_positions")
    advice = "Add the same swing to each of the six positions."
    targets = recording.stream(MYROBOT.topic(TARGETS), "data")
    expect_width(targets, JOINTS, advice=advice, where=where)
    expect_alike(targets, advice=advice, where=where)


@client.check("client_rate", "it sends 100 targets per second", points=2, needs="sends")
def client_rate(recording: Recording) -> None:
    own = only_script(recording).sources
    where = places(own, "Clock")
    if places(own, "update_and_sleep") and not places(own, "init"):
        raise Failure(
            Feedback(
                summary="The clock is never started. On a real robot, it would count all cycles since 1970.",
                where=where,
                advice="Create the clock, then call `clock.init()` just before the loop.",
            )
        )
    advice = "Use `Clock(0.01)`, then `clock.init()`. Call `clock.update_and_sleep()` once in each cycle."
    expect_rate(
        recording, recording.stream(MYROBOT.topic(TARGETS), "data"), 100.0, advice=advice, where=where
    )


@client.check("client_end", "Ctrl+C ends it cleanly", needs="runs")
def client_end(recording: Recording) -> None:
    expect_clean_interrupt(only_script(recording), SCRIPT)


def only_script(recording: Recording) -> Recording:
    """The recording as if the package contained only the script, for feedback about Python."""
    text = recording.sources.files.get(SCRIPT_FILE)
    return replace(recording, sources=Sources({SCRIPT_FILE: text} if text is not None else {}))


def places(sources: Sources, name: str) -> tuple[Location, ...]:
    return tuple(call.where for call in calls(sources, name))[:2]


# 31-driver-python ------------------------------------------------------------------------------------


@in_python.scenario
def node_of_python(arena: Arena) -> None:
    def start(robot: Robot, name: str) -> Process | None:
        return arena.run(IN_PYTHON, PYTHON_NODE, params=robot.parameters, node_name=robot.name, name=name)

    two_lives(arena, (WRITING, DRAWING), PYTHON_NODE, start)


@in_python.check("python_starts", "the node starts with its parameters and keeps running")
def python_starts(recording: Recording) -> None:
    expect_running(recording, PYTHON_NODE)


@in_python.check("python_topics", "it has the topics of a driver", points=2, needs="python_starts")
def python_topics(recording: Recording) -> None:
    prefix = "Start each topic with the node's own name, `self.get_name()`, or with `~/`."
    expect_topics(recording, WRITING, prefix, "Compare your topics and their types with the task.")


@in_python.check("python_limits", "the limits are those in the parameters, in radians", needs="python_topics")
def python_limits(recording: Recording) -> None:
    advice = "Convert each number in the parameter with `math.radians`."
    expect_limits(recording, WRITING, advice, places(recording.sources, "declare_parameter"))


@in_python.check("python_joints", "it has six joints, which start at zero", needs="python_topics")
def python_joints(recording: Recording) -> None:
    expect_zeros(
        recording, WRITING, "Start with `[0.0] * 6`, and change the positions only when a target arrives."
    )


@in_python.check(
    "python_rate", "the joint positions come at the rate in the parameter", needs="python_topics"
)
def python_rate(recording: Recording) -> None:
    where = places(recording.sources, "create_timer")
    advice = "Pass the parameter `thread_sampling_time_sec` to `create_timer`."
    expect_rate(recording, states_of(recording, WRITING), 1 / WRITING.period, advice=advice, where=where)
    if recording.marked(WRONG):
        expect_rate(recording, states_of(recording, DRAWING), 1 / DRAWING.period, advice=advice, where=where)


@in_python.check("python_step", "a target takes effect within 25 ms", needs="python_joints")
def python_step(recording: Recording) -> None:
    advice = "Store the target's `data` in a member, so that the timer's function can use it."
    expect_step_and_wave(
        recording, WRITING, "steps", advice, places(recording.sources, "create_subscription")
    )


@in_python.check("python_wave", "the joints follow a sine exactly", needs="python_joints")
def python_wave(recording: Recording) -> None:
    advice = "Publish all six numbers of the last target from `set/target_joint_positions`, in their order."
    expect_step_and_wave(recording, WRITING, "wave", advice, places(recording.sources, "create_subscription"))


@in_python.check("python_wrong", "a target of five elements ends it cleanly", needs="python_joints")
def python_wrong(recording: Recording) -> None:
    advice = "Check `len(message.data)` first. Log an error, and raise an exception that `main` catches."
    order = "In `main`, switch off and disconnect in a `finally` block, which runs however `spin` ends."
    expect_end_by_a_wrong_target(recording, AGAIN, advice, order, WORDS)


@in_python.check("python_end", "Ctrl+C ends it cleanly", needs="python_starts")
def python_end(recording: Recording) -> None:
    expect_clean_interrupt(recording, PYTHON_NODE)
    view = recording.process(PYTHON_NODE)
    order = "In `main`, switch off and disconnect in a `finally` block, which runs however `spin` ends."
    expect_order(view, view.interrupted_at or 0.0, "Ctrl+C", order, WORDS)
