"""Expectations about a launch file: that it is installed, starts its programs, and ends them.

`file` is the launch file's name, and also the name under which the scenario launched it.
"""

from __future__ import annotations

import ast
import re
from pathlib import PurePosixPath

from course.errors import OurFault
from course.evidence.parameter_view import ParameterData
from course.evidence.process_view import LaunchView, ProcessView
from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.explain.cmake import LISTS
from course.explain.engine import Cause
from course.explain.launch_files import (
    dict_in_arguments,
    launch_file_cause,
    not_installed,
    of_another_node,
    started_twice,
)
from course.explain.parameter_causes import named
from course.explain.python_code import calls, nodes, text_places
from course.grading.expect.endpoints import expect_node
from course.grading.expect.parameters import expect_declared, expect_parameter
from course.grading.expect.programs import expect_clean_interrupt, expect_running
from course.model import replace
from course.model.events import Event
from course.model.feedback import Failure, Feedback, Location
from course.spelling import listed, nearest

_NOT_FOUND = "was not found in the share directory"
_NO_FILE = re.compile(r"Parameter file path is not a file: (?P<path>\S+)")
_NO_PROGRAM = re.compile(r"executing process: .*No such file or directory: '(?P<name>[^']+)'")
_LINE = re.compile(r", line (?P<line>\d+)\)")
_WRONG_TYPE = re.compile(
    r"Trying to set parameter '(?P<name>[^']+)' to '.*' of type '(?P<given>\w+)', "
    r"expecting type '(?P<wanted>\w+)'"
    r"|parameter \{(?P<cpp>[^}]+)\} is of type \{(?P<needed>\w+)\}, setting it to \{(?P<found>\w+)\}"
)
_WRITTEN = {
    "STRING": "in quotes",
    "DOUBLE": "without quotes and with a decimal point, such as `0.5` or `1.0`",
    "INTEGER": "without quotes and without a decimal point",
    "DOUBLE_ARRAY": "with a decimal point in each number, such as `[0.5, 1.0]`",
    "BOOL": "as `True` or `False`, without quotes",
}
_IMPORT = "`Node` from launch_ros starts nodes: `from launch_ros.actions import Node`."
# What the error contains -> what to do. The first match counts.
_ADVICE = (
    (
        ("SyntaxError", "IndentationError"),
        "Python cannot read the file. Check this line and the end of the line before it.",
    ),
    (("cannot import name 'Node'", "name 'Node' is not defined", "keyword argument 'package'"), _IMPORT),
    (("argument: 'executable'",), "`Node` must know what to start: `package=...` and `executable=...`."),
    (
        ("must return a LaunchDescription", "expected a list of actions", "'Node' object is not iterable"),
        "The function must end with `return LaunchDescription([Node(...)])`: a list of nodes, "
        "each with its own parentheses.",
    ),
)
_OTHERWISE = "The message names the error. `ros2 launch --debug ...` shows where it comes from."


def expect_launch_file(recording: Recording, package: str, file: str) -> None:
    """Check that `ros2 launch` finds the launch file among the files that the package installs."""
    built = recording.packages.get(package)
    if built and any(_NOT_FOUND in text for text in _view(recording, file).main.text):
        raise Failure(not_installed(recording.sources, built.source, file))


def expect_launched(recording: Recording, file: str) -> None:
    """Check that `ros2 launch` reads the file, and all its programs run until the scenario ends them."""
    view = _view(recording, file)
    if view.error:
        raise Failure(_unreadable(recording, file, view.error))
    if not view.processes:
        raise Failure(_nothing(recording, file))
    for name in view.processes:
        _expect_no_wrong_type(recording, file, view.processes[name])
        expect_running(_by_themselves(recording, view), name)


def expect_launched_node(recording: Recording, file: str, name: str) -> None:
    """Check that a node appeared with this full name, which the launch file gives it."""
    nodes = recording.seen_nodes()
    if name in nodes:
        return
    plain = name.lstrip("/")
    own = launch_file(recording, file)
    wrong = _wrong_naming(own, plain) or started_twice(own)
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
            where=wrong.where if wrong else given[:1] or tuple(call.where for call in calls(own, "Node"))[:1],
            advice=wrong.text
            if wrong
            else "Its name is right, but it has a namespace before it: remove `namespace`."
            if spaced
            else f"The launch file sets its name: pass `name='{plain}'` to `Node`.",
        )
    )


def _wrong_naming(own: Sources, name: str) -> Cause | None:
    """A launch file that passes the node's name in the wrong place."""
    for node in calls(own, "Node"):
        space = node.keywords.get("namespace")
        if isinstance(space, ast.Constant) and str(space.value).strip("/") == name:
            text = f"`namespace` comes before the node's name. Write `name='{name}'` instead."
            return Cause(text, (Location(node.where.file, space.lineno),))
    places = [place for text in ("'_node:=", '"_node:=') for place in text_places(own, text)]
    text = f"`node` needs two underscores before it: `__node:={name}`."
    return Cause(text, tuple(places[:1])) if places else None


def expect_launch_parameter(
    recording: Recording, file: str, node: str, name: str, value: ParameterData
) -> None:
    """Check that the launch file gives the parameter this value, by asking the node itself."""
    try:
        expect_parameter(recording, node, name, value)
    except Failure as failure:
        _expect_no_slip(recording, file, name)
        where, advice = _setting(recording, file, name), _to_set(name, repr(value))
        if wrong := of_another_node(launch_file(recording, file), node.strip("/"), name):
            where, advice = wrong.where, wrong.text
        raise Failure(replace(failure.feedback, where=where, advice=advice)) from None


def expect_own_launch_parameter(
    recording: Recording, file: str, node: str, name: str, default: ParameterData
) -> None:
    """Check that the launch file gives the parameter a value that is neither empty nor its default."""
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
                expected="your own value",
                seen=repr(found.value),
                where=_setting(recording, file, name),
                advice=_to_set(name, "'...'"),
            )
        )


def expect_launch_interrupt(recording: Recording, file: str) -> None:
    """Check that one Ctrl+C ended `ros2 launch` and all its programs, within 3 s, without a traceback."""
    view = _view(recording, file)
    for name in view.processes:
        expect_clean_interrupt(_by_themselves(recording, view), name)
    if view.left:
        raise Failure(
            Feedback(
                summary="Ctrl+C ended `ros2 launch`, but a program that it started kept running.",
                expected="all programs end with `ros2 launch`",
                seen=" ".join(view.left[0].command)[:120],
                advice="A program must end when it gets SIGINT, the signal that Ctrl+C sends.",
            )
        )
    expect_clean_interrupt(recording, file)


def launch_file(recording: Recording, file: str) -> Sources:
    """Return only the launch file with this name, so that `expect_*` helpers look for a cause there."""
    found = {path: text for path, text in recording.sources.files.items() if PurePosixPath(path).name == file}
    return Sources(found)


def _expect_no_slip(recording: Recording, file: str, name: str) -> None:
    """Check for mistakes that ROS accepts silently, such as a misspelled parameter in the launch file."""
    _expect_no_yaml(recording, file)
    _expect_parameter_files(recording, file)
    own = launch_file(recording, file)
    if wrong := dict_in_arguments(own):
        raise Failure(
            Feedback(
                summary=f"The parameter `{name}` does not reach the node.",
                where=wrong.where,
                advice=wrong.text,
            )
        )
    close = None if named(own, name) else nearest(name, _texts(own))
    if close:
        raise Failure(
            Feedback(
                summary=f"The launch file sets `{close}`; the node's parameter is called `{name}`.",
                expected=name,
                seen=close,
                where=named(own, close)[:1],
                advice="Spell it as the node declares it. ROS ignores a parameter that no node declares.",
            )
        )


def _expect_no_yaml(recording: Recording, file: str) -> None:
    """Check that no `ros__parameters` wraps the parameters; in a dict, it is just another parameter."""
    places = named(launch_file(recording, file), "ros__parameters")
    if places:
        raise Failure(
            Feedback(
                summary="`ros__parameters` belongs in a YAML file. In a launch file's dict it hides the "
                "parameters inside it.",
                expected="parameters=[{'period': 0.25, ...}]",
                seen="parameters=[{'ros__parameters': {...}}]",
                where=places[:1],
                advice="Leave out `ros__parameters`: put the names and values directly into the dict.",
            )
        )


def _expect_parameter_files(recording: Recording, file: str) -> None:
    """Check that each parameter file was where the launch file looks for it."""
    for text in _view(recording, file).main.text:
        found = _NO_FILE.search(text)
        if found:
            name = PurePosixPath(found["path"]).name
            own = launch_file(recording, file)
            above = [path.rpartition("/launch/")[0] for path in own.files]
            setup = (Location(f"{one}/{build}") for one in above for build in ("setup.py", LISTS))
            there = tuple(place for place in setup if place.file in recording.sources.names)
            raise Failure(
                Feedback(
                    summary=f"`ros2 launch` does not find the parameter file `{name}`, and starts the "
                    "node without it.",
                    expected=f"`{name}` among the installed files",
                    where=(*text_places(own, name), *there)[:2],
                    advice=f"Install `{name}` as you install the launch file, for example in `data_files` "
                    "of setup.py, and compare its folder with the path in the launch file.",
                )
            )


def _texts(sources: Sources) -> set[str]:
    return {
        node.value
        for _, node in nodes(sources)
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
    }


def _setting(recording: Recording, file: str, name: str) -> tuple[Location, ...]:
    own = launch_file(recording, file)
    return named(own, name)[:1] or tuple(call.where for call in calls(own, "Node"))[:1]


def _to_set(name: str, value: str) -> str:
    return f"Add it to `parameters` in the launch file: `'{name}': {value}`."


def _view(recording: Recording, file: str) -> LaunchView:
    view = recording.launched(file)
    if view.main.started is None:
        raise OurFault(f"the scenario did not launch {file}")
    return view


def _by_themselves(recording: Recording, view: LaunchView) -> Recording:
    """The recording as if the scenario had run each launched program itself."""
    events = (event for one in view.processes.values() for event in _events(one))
    every = sorted((*recording.events, *events), key=lambda event: event.t)
    return replace(recording, events=tuple(every))


def _events(view: ProcessView) -> list[Event]:
    signals = [replace(sent, process=view.name) for sent in view.signals]
    ends: list[Event] = [event for event in (view.started, view.exited) if event]
    return [*view.lines, *signals, *ends]


def _unreadable(recording: Recording, file: str, error: str) -> Feedback:
    cause = launch_file_cause(recording.sources, recording.packages, file, error)
    return Feedback(
        summary=f"`ros2 launch` cannot use the launch file: {_short(error)}",
        where=cause.where if cause else _place(launch_file(recording, file), file, error),
        advice=cause.text
        if cause
        else next((advice for words, advice in _ADVICE if any(word in error for word in words)), _OTHERWISE),
    )


def _place(own: Sources, file: str, error: str) -> tuple[Location, ...]:
    """The line that the error names, else the line of the `Node` that it is about, else the file."""
    line = _LINE.search(error) if f"({file}," in error else None
    if line:
        return tuple(Location(path, int(line["line"])) for path in own.files)
    nodes = tuple(call.where for call in calls(own, "Node")) if "Node" in error else ()
    return nodes[:1] or tuple(Location(path) for path in own.files)


def _short(error: str) -> str:
    """The error without launch's preface, and without the build and ROS folders."""
    said = error.rpartition("(see debug for traceback): ")[2].partition(", searching:")[0]
    said = re.sub(r"'/[^']*/([^'/]+)'", r"'\1'", said)
    return re.sub(r" \(/[^)]*\)| object at 0x[0-9a-f]+", "", said).strip()


def _nothing(recording: Recording, file: str) -> Feedback:
    own = launch_file(recording, file)
    lost = next(filter(None, map(_NO_PROGRAM.search, _view(recording, file).main.text)), None)
    if lost:
        return Feedback(
            summary=f"`ros2 launch` cannot start a program: there is no command `{lost['name']}`.",
            where=(*named(own, lost["name"]), *(call.where for call in calls(own, "ExecuteProcess")))[:1],
            advice="Each word of the command must be a separate string: `['ros2', 'run', ...]`."
            if " " in lost["name"]
            else "Check the spelling of the first word of the command.",
        )
    nodes = calls(own, "Node")
    places = (nodes or calls(own, "LaunchDescription"))[:1]
    return Feedback(
        summary="`ros2 launch` reads the file but starts nothing: `LaunchDescription` contains no node.",
        expected="one node",
        seen="no program",
        where=tuple(call.where for call in places),
        advice="The `Node(...)` must be in the list: `LaunchDescription([Node(...)])`."
        if nodes
        else "Put a `Node(...)` in the list that you pass to `LaunchDescription`.",
    )


def _expect_no_wrong_type(recording: Recording, file: str, view: ProcessView) -> None:
    found = next((match for match in map(_WRONG_TYPE.search, view.text) if match), None)
    if found:
        name, given = found["name"] or found["cpp"], (found["given"] or found["found"]).lower()
        wanted = (found["wanted"] or found["needed"]).upper()
        raise Failure(
            Feedback(
                summary=f"The launch file gives `{name}` the type {given}, but the node "
                f"declares it as {wanted.lower()}, so the node stops.",
                expected=f"the type {wanted.lower()}",
                seen=f"the type {given}",
                where=named(launch_file(recording, file), name)[:1],
                advice=f"Write its value {_WRITTEN.get(wanted, f'as a {wanted.lower()}')}.",
                details=(found.group(),),
            )
        )
