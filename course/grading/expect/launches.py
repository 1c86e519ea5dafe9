"""What is expected of a launch file: that it is installed, starts its programs, and ends them.

`file` is the launch file's name, and the name under which the scenario launched it.
"""

from __future__ import annotations

import ast
import re
from dataclasses import replace
from pathlib import PurePosixPath

from course.errors import OurFault
from course.evidence.events import Event
from course.evidence.launch_view import LaunchView
from course.evidence.parameter_types import ParameterData
from course.evidence.process_view import ProcessView
from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.feedback import Failure, Feedback, Location
from course.grading.expect.graph import expect_node
from course.grading.expect.parameters import expect_declared, expect_parameter
from course.grading.expect.programs import expect_clean_interrupt, expect_running
from course.grading.explain.launch_files import launch_file_cause, not_installed
from course.grading.explain.names import listed, nearest
from course.grading.explain.parameters import named
from course.grading.explain.python_code import calls, trees

_NOT_FOUND = "was not found in the share directory"
_LINE = re.compile(r", line (?P<line>\d+)\)")
_WRONG_TYPE = re.compile(
    r"Trying to set parameter '(?P<name>[^']+)' to '.*' of type '(?P<given>\w+)', "
    r"expecting type '(?P<wanted>\w+)'"
)
_WRITTEN = {
    "STRING": "in quotes",
    "DOUBLE": "without quotes and with a point, such as `0.5` or `1.0`",
    "INTEGER": "without quotes and without a point",
    "BOOL": "as `True` or `False`, without quotes",
}
_IMPORT = "Nodes are started by the `Node` of launch_ros: `from launch_ros.actions import Node`."
# What the error holds -> what to do. The first that fits is taken.
_ADVICE = (
    (
        ("SyntaxError", "IndentationError"),
        "Python cannot read the file. Look at the line named here, and at the end of the one before.",
    ),
    (("cannot import name 'Node'", "name 'Node' is not defined", "keyword argument 'package'"), _IMPORT),
    (("argument: 'executable'",), "`Node` must know what to start: `package=...` and `executable=...`."),
    (
        ("must return a LaunchDescription", "expected a list of actions"),
        "The function ends with `return LaunchDescription([Node(...)])`: a list of nodes, and each with its "
        "arguments in brackets of its own.",
    ),
)
_OTHERWISE = "The message names the error. `ros2 launch --debug ...` shows where it comes from."


def expect_launch_file(recording: Recording, package: str, file: str) -> None:
    """`ros2 launch` finds the launch file among what the package installs."""
    built = recording.packages.get(package)
    if built and any(_NOT_FOUND in text for text in _view(recording, file).main.text):
        raise Failure(not_installed(recording.sources, built.source, file))


def expect_launched(recording: Recording, file: str) -> None:
    """`ros2 launch` reads the file, and what it starts runs until the scenario ended it."""
    view = _view(recording, file)
    if view.error:
        raise Failure(_unreadable(recording, file, view.error))
    if not view.processes:
        raise Failure(_nothing(recording, file))
    for name in view.processes:
        _expect_no_wrong_type(recording, file, view.processes[name])
        expect_running(_by_themselves(recording, view), name)


def expect_launched_node(recording: Recording, file: str, name: str) -> None:
    """A node of this full name was in the graph, by the name that the launch file gives it."""
    nodes = recording.seen_nodes()
    if name in nodes:
        return
    plain = name.lstrip("/")
    own = launch_file(recording, file)
    if not nodes:
        expect_node(recording, name)
    close = next((node for node in nodes if node.endswith(name)), None) or nearest(name, nodes) or nodes[0]
    spaced = close.endswith(name)
    given = named(own, close.rpartition("/")[2])
    raise Failure(
        Feedback(
            summary=f"The node is called `{close}`, not `{name}`.",
            expected=name,
            seen=listed(nodes),
            where=given[:1] or tuple(call.where for call in calls(own, "Node"))[:1],
            advice="Its name is right, but it has a namespace, which stands before it: leave `namespace` out."
            if spaced
            else f"The launch file names it: `name='{plain}'` among the arguments of `Node`.",
        )
    )


def expect_launch_parameter(
    recording: Recording, file: str, node: str, name: str, value: ParameterData
) -> None:
    """The launch file gives the node's parameter this value, as the node itself told when it was asked."""
    try:
        expect_parameter(recording, node, name, value)
    except Failure as failure:
        _expect_no_slip(recording, file, name)
        where, advice = _setting(recording, file, name), _to_set(name, repr(value))
        raise Failure(replace(failure.feedback, where=where, advice=advice)) from None


def expect_own_launch_parameter(
    recording: Recording, file: str, node: str, name: str, default: ParameterData
) -> None:
    """The launch file gives the node's parameter a value that is neither empty nor its default."""
    expect_declared(recording, node, name, default)
    found = recording.parameters(node).get(name)
    if found is None:
        raise OurFault(f"the scenario did not get the parameter {name} of {node}")
    if found.value in ("", default):
        _expect_no_slip(recording, file, name)
        raise Failure(
            Feedback(
                summary=f"The parameter `{name}` is empty."
                if found.value == ""
                else f"The parameter `{name}` still has its default value.",
                expected="a value of your own",
                seen=repr(found.value),
                where=_setting(recording, file, name),
                advice=_to_set(name, "'...'"),
            )
        )


def expect_launch_interrupt(recording: Recording, file: str) -> None:
    """One Ctrl+C ended `ros2 launch` and all that it had started, within 3 s and with no traceback."""
    view = _view(recording, file)
    for name in view.processes:
        expect_clean_interrupt(_by_themselves(recording, view), name)
    if view.left:
        raise Failure(
            Feedback(
                summary="Ctrl+C ended `ros2 launch`, but a program that it had started still ran.",
                expected="all programs end with `ros2 launch`",
                seen=" ".join(view.left[0].command)[:120],
                advice="A program must end when it gets SIGINT, the signal that Ctrl+C sends.",
            )
        )
    expect_clean_interrupt(recording, file)


def launch_file(recording: Recording, file: str) -> Sources:
    """The launch file of this name alone: where `expect_*` helpers then look for a cause."""
    found = {path: text for path, text in recording.sources.files.items() if PurePosixPath(path).name == file}
    return Sources(found)


def _expect_no_slip(recording: Recording, file: str, name: str) -> None:
    """A launch file that sets a parameter of nearly this name: ROS says nothing of it."""
    own = launch_file(recording, file)
    close = None if named(own, name) else nearest(name, _texts(own))
    if close:
        raise Failure(
            Feedback(
                summary=f"The launch file sets `{close}`; the node's parameter is called `{name}`.",
                expected=name,
                seen=close,
                where=named(own, close)[:1],
                advice="Spell it as the node declares it. ROS says nothing of a parameter that no node "
                "declares.",
            )
        )


def _texts(sources: Sources) -> set[str]:
    every = (node for _, tree in trees(sources) for node in ast.walk(tree))
    return {node.value for node in every if isinstance(node, ast.Constant) and isinstance(node.value, str)}


def _setting(recording: Recording, file: str, name: str) -> tuple[Location, ...]:
    own = launch_file(recording, file)
    return named(own, name)[:1] or tuple(call.where for call in calls(own, "Node"))[:1]


def _to_set(name: str, value: str) -> str:
    return f"Set it in the launch file, among the `parameters`: `'{name}': {value}`."


def _view(recording: Recording, file: str) -> LaunchView:
    view = recording.launched(file)
    if view.main.started is None:
        raise OurFault(f"the scenario did not launch {file}")
    return view


def _by_themselves(recording: Recording, view: LaunchView) -> Recording:
    """The recording as if the scenario itself had run each program that was launched."""
    events = (event for one in view.processes.values() for event in _events(one))
    return replace(recording, events=tuple(sorted((*recording.events, *events), key=lambda event: event.t)))


def _events(view: ProcessView) -> list[Event]:
    signals = [replace(sent, process=view.name) for sent in view.signals]
    ends: list[Event] = [event for event in (view.started, view.exited) if event]
    return [*view.lines, *signals, *ends]


def _unreadable(recording: Recording, file: str, error: str) -> Feedback:
    cause = launch_file_cause(recording.sources, recording.packages, file)
    return Feedback(
        summary=f"`ros2 launch` cannot use the launch file: {_short(error)}",
        where=cause.where if cause else _place(launch_file(recording, file), file, error),
        advice=cause.text
        if cause
        else next((advice for words, advice in _ADVICE if any(word in error for word in words)), _OTHERWISE),
    )


def _place(own: Sources, file: str, error: str) -> tuple[Location, ...]:
    """The line that the error names, or that of the `Node` it is about, or the file."""
    line = _LINE.search(error) if f"({file}," in error else None
    if line:
        return tuple(Location(path, int(line["line"])) for path in own.files)
    nodes = tuple(call.where for call in calls(own, "Node")) if "Node" in error else ()
    return nodes[:1] or tuple(Location(path) for path in own.files)


def _short(error: str) -> str:
    """Without launch's own preface, and without the folders of the build and of ROS."""
    said = error.rpartition("(see debug for traceback): ")[2].partition(", searching:")[0]
    said = re.sub(r"'/[^']*/([^'/]+)'", r"'\1'", said)
    return re.sub(r" \(/[^)]*\)| object at 0x[0-9a-f]+", "", said).strip()


def _nothing(recording: Recording, file: str) -> Feedback:
    own = launch_file(recording, file)
    nodes = calls(own, "Node")
    places = (nodes or calls(own, "LaunchDescription"))[:1]
    return Feedback(
        summary="`ros2 launch` reads the file, and starts nothing: `LaunchDescription` holds no node.",
        expected="one node",
        seen="no program",
        where=tuple(call.where for call in places),
        advice="The `Node(...)` must stand in the list: `LaunchDescription([Node(...)])`."
        if nodes
        else "Put a `Node(...)` into the list that `LaunchDescription` gets.",
    )


def _expect_no_wrong_type(recording: Recording, file: str, view: ProcessView) -> None:
    found = next((match for match in map(_WRONG_TYPE.search, view.text) if match), None)
    if found:
        name, wanted = found["name"], found["wanted"]
        raise Failure(
            Feedback(
                summary=f"The launch file gives `{name}` the type {found['given'].lower()}, but the node "
                f"declares it as {wanted.lower()}, and so it stops.",
                expected=f"the type {wanted.lower()}",
                seen=f"the type {found['given'].lower()}",
                where=named(launch_file(recording, file), name)[:1],
                advice=f"Write its value {_WRITTEN.get(wanted, f'as a {wanted.lower()}')}.",
                details=(found.group(),),
            )
        )
