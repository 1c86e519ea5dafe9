"""What is usually wrong with a node's parameters."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

from course.evidence.sources import Sources
from course.feedback import Location
from course.grading.explain.callbacks import in_callbacks
from course.grading.explain.names import nearest
from course.grading.explain.python_code import Call, called_name, calls, text_places, trees
from course.grading.explain.timers import Cause

_UNDECLARED = re.compile(
    r"ParameterNotDeclaredException: .*undeclared parameter\(s\): \[?'?(?P<name>[^'\],]*)"
)
# What Python, a message's field and rclpy say of a Parameter where its value belongs.
_WRONG_TYPE = ("not 'Parameter'", "field must be of type", "incompatible function arguments")
_READERS = ("get_parameter", "get_parameters", "get_parameter_or")


def undeclared(error: str, sources: Sources) -> Cause | None:
    """What an exception's line means that complains of a parameter that was never declared."""
    match = _UNDECLARED.search(error)
    if not match:
        return None
    name = match["name"]
    close = nearest(name, declared(sources) - {name})
    if close:
        places = (*named(sources, name), *named(sources, close))
        return Cause(f"The node declares `{close}`, and asks for `{name}`: spell both the same.", places[:2])
    return Cause(
        f"A parameter must be declared before it is read: `self.declare_parameter('{name}', ...)` in "
        "`__init__`, with its default value."
    )


def value_forgotten(error: str, sources: Sources) -> Cause | None:
    """`get_parameter(...)` without `.value`, when an exception's line complains of something's type."""
    if not any(words in error for words in _WRONG_TYPE):
        return None
    for file, tree in trees(sources):
        for call in _whole_parameters(tree):
            written = ast.unparse(call)
            text = f"`{written}` is the parameter itself. Its value is `{written}.value`."
            return Cause(text, (Location(file, call.lineno),))
    return None


def _whole_parameters(tree: ast.Module) -> Iterator[ast.Call]:
    """Calls of `get_parameter` whose `.value` is not taken, neither at once nor by the name it is given."""
    nodes = list(ast.walk(tree))
    taken = [node.value for node in nodes if isinstance(node, ast.Attribute)]
    names = {_name(node) for node in taken}
    given = {node.value: _name(node.targets[0]) for node in nodes if isinstance(node, ast.Assign)}
    reads = (node for node in nodes if isinstance(node, ast.Call) and called_name(node) == "get_parameter")
    return (read for read in reads if read not in taken and given.get(read) not in names)


def _name(node: ast.expr) -> str:
    """`period` for both `period` and `self.period`."""
    return ast.unparse(node).rpartition(".")[2]


def declared(sources: Sources) -> set[str]:
    """Names that stand in calls of `declare_parameter` and `declare_parameters`."""
    every = (*calls(sources, "declare_parameter"), *calls(sources, "declare_parameters"))
    return {name for call in every for name in _texts(call)}


def named(sources: Sources, name: str) -> tuple[Location, ...]:
    """Lines of the learner's code that hold this name in quotes."""
    return tuple(place for quote in "'\"" for place in text_places(sources, f"{quote}{name}{quote}"))


def read_once(sources: Sources, name: str) -> Cause | None:
    """A parameter that is read while the node is made, and in no callback."""
    if any(in_callbacks(sources, reader) for reader in _READERS):
        return None
    reads = [call.where for reader in _READERS for call in calls(sources, reader) if name in _texts(call)]
    return Cause(
        f"`{name}` is read once, when the node is made. Read it in the callback, each time: "
        f"`self.get_parameter('{name}').value`.",
        tuple(reads[:1]),
    )


def _texts(call: Call) -> set[str]:
    parts = (part for value in (*call.args, *call.keywords.values()) for part in ast.walk(value))
    return {part.value for part in parts if isinstance(part, ast.Constant) and isinstance(part.value, str)}
