"""Common mistakes with a node's parameters."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

from course.evidence.sources import Sources
from course.explain.callbacks import in_callbacks
from course.explain.engine import Cause
from course.explain.python_code import PythonCall, called_name, calls, last_name, text_places, trees
from course.model.feedback import Location
from course.spelling import nearest

_UNDECLARED = re.compile(
    r"ParameterNotDeclaredException: .*undeclared parameter\(s\): \[?'?(?P<name>[^'\],]*)"
)
# What Python, message fields and rclpy say if they get a Parameter instead of its value.
_WRONG_TYPE = (
    "not 'Parameter'", "and 'Parameter'", "'Parameter' and", "ParameterValue", "field must be of type",
    "incompatible function arguments",
)  # fmt: skip
_READERS = ("get_parameter", "get_parameters", "get_parameter_or")


def undeclared(error: str, sources: Sources) -> Cause | None:
    """Why an exception complains about a parameter that was never declared."""
    match = _UNDECLARED.search(error)
    if not match:
        return None
    name = match["name"]
    close = nearest(name, declared(sources) - {name})
    if close:
        places = (*named(sources, name), *named(sources, close))
        return Cause(f"The node declares `{close}` but reads `{name}`: spell both the same way.", places[:2])
    for call in calls(sources, "declare_parameters"):
        prefix, given = call.argument(0, "namespace"), call.argument(1, "parameters")
        if isinstance(given, ast.Constant):
            text = f"One parameter is declared by `declare_parameter('{name}', ...)`. The plural, "
            return Cause(f"{text}`declare_parameters`, takes a list of several.", (call.where,))
        before = str(prefix.value) if isinstance(prefix, ast.Constant) else ""
        rows = (node for _, tree in trees(sources) for node in tree.body if isinstance(node, ast.Assign))
        rows = (node for node in rows if given and last_name(node.targets[0]) == last_name(given))
        listed = {getattr(part, "value", None) for node in rows for part in ast.walk(node.value)}
        if before and name in declared(sources) | listed:
            text = f"`{name}` is declared as `{before}.{name}`: `declare_parameters` puts its "
            return Cause(f"{text}first argument before each name. Pass `''` instead.", (call.where,))
    return Cause(
        f"A parameter must be declared before it is read: `self.declare_parameter('{name}', ...)` in "
        "`__init__`, with its default value."
    )


def value_forgotten(error: str, sources: Sources) -> Cause | None:
    """`get_parameter(...)` without `.value`, if an exception complains about a type."""
    if not any(words in error for words in _WRONG_TYPE):
        return None
    for file, tree in trees(sources):
        for call in _used_whole(tree, "get_parameter_value"):
            text = (
                "Write `.value` instead of `.get_parameter_value()`, or add `.string_value`, "
                "`.double_value`, or `.integer_value` after it."
            )
            return Cause(text, (Location(file, call.lineno),))
        for call in _used_whole(tree, "get_parameter"):
            written = ast.unparse(call)
            text = f"`{written}` is the parameter, not its value. The value is `{written}.value`."
            return Cause(text, (Location(file, call.lineno),))
        for name in _whole_of_several(tree):
            text = f"`{name.id}` is the parameter, not its value. The value is `{name.id}.value`."
            return Cause(text, (Location(file, name.lineno),))
    return None


def _whole_of_several(tree: ast.Module) -> Iterator[ast.Name]:
    """`topic` in `topic, period = node.get_parameters(...)`, if its `.value` is never read."""
    nodes = list(ast.walk(tree))
    taken = {last_name(node.value) for node in nodes if isinstance(node, ast.Attribute)}
    for node in nodes:
        value = node.value if isinstance(node, ast.Assign) else None
        if isinstance(node, ast.Assign) and isinstance(value, ast.Call):
            several = called_name(value) == "get_parameters" and isinstance(node.targets[0], ast.Tuple)
            for part in ast.walk(node.targets[0]) if several else ():
                if isinstance(part, ast.Name) and part.id not in taken:
                    yield part


def _used_whole(tree: ast.Module, getter: str) -> Iterator[ast.Call]:
    """Calls of `getter` with no attribute read from the result, neither directly nor through a variable."""
    nodes = list(ast.walk(tree))
    taken = [node.value for node in nodes if isinstance(node, ast.Attribute)]
    names = {last_name(node) for node in taken}
    given = {node.value: last_name(node.targets[0]) for node in nodes if isinstance(node, ast.Assign)}
    reads = (node for node in nodes if isinstance(node, ast.Call) and called_name(node) == getter)
    return (read for read in reads if read not in taken and given.get(read) not in names)


def declared(sources: Sources) -> set[str]:
    """Names in calls of `declare_parameter` and `declare_parameters`."""
    every = (*calls(sources, "declare_parameter"), *calls(sources, "declare_parameters"))
    return {name for call in every for name in _texts(call)}


def named(sources: Sources, name: str) -> tuple[Location, ...]:
    """Return the lines of the learner's code that contain this name in quotes."""
    return tuple(place for quote in "'\"" for place in text_places(sources, f"{quote}{name}{quote}"))


def read_once(sources: Sources, name: str) -> Cause | None:
    """A parameter that is read only when the node is created, not in any callback."""
    if any(in_callbacks(sources, reader) for reader in _READERS):
        return None
    reads = [call.where for reader in _READERS for call in calls(sources, reader) if name in _texts(call)]
    return Cause(
        f"`{name}` is read only once, when the node is created. Read it in the callback each time: "
        f"`self.get_parameter('{name}').value`.",
        tuple(reads[:1]),
    )


def _texts(call: PythonCall) -> set[str]:
    parts = (part for value in (*call.args, *call.keywords.values()) for part in ast.walk(value))
    return {part.value for part in parts if isinstance(part, ast.Constant) and isinstance(part.value, str)}
