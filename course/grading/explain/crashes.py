"""What a program's exception means for a beginner: the cause and the next step."""

from __future__ import annotations

import ast
import re
from dataclasses import dataclass
from pathlib import PurePosixPath

from course.evidence.packages import BuiltPackages
from course.evidence.sources import Sources
from course.feedback import Feedback, Location
from course.grading.explain.names import listed
from course.grading.explain.parameters import undeclared, value_forgotten
from course.grading.explain.python_code import parsed
from course.grading.explain.services import (
    fields_of_the_request,
    no_response,
    not_the_response,
    result_too_early,
)
from course.grading.explain.setup_py import EntryPoint, entry_points
from course.grading.explain.timers import Cause, called_callback
from course.grading.explain.tracebacks import Crash

_NO_MODULE = re.compile(r"No module named '(?P<name>[\w.]+)'")
_NO_NAME = re.compile(
    r"cannot import name '(?P<name>\w+)' from '(?P<module>[\w.]+)'"
    r"|module '(?P<module2>[\w.]+)' has no attribute '(?P<name2>\w+)'"
)
_ON_THE_REQUEST = re.compile(r"'\w+_Request' object has no attribute")
_INIT = "Call `rclpy.init()` at the beginning of `main()`, before the node is made."
_INIT_OF_SAS = "Call `rclcpp_init()` of `sas_common` first, before `rclcpp_Node(...)` makes the node."
_NOT_STARTED = ("rclpy.init() has not been called", "NotInitializedException")
_SUPER = "Call `super().__init__('name_of_the_node')` first in the class's `__init__`."
_NO_NODE = "The class must derive from Node: `class ...(Node):`."
_BRACKETS = "A function is named but not called: `get_logger()` needs its brackets."
# Words of the exception's line -> what to do. The first that fits is taken.
_KNOWN = (
    *(((words,), _INIT) for words in _NOT_STARTED),
    (("Context.init() must only be called once",), "Call `rclpy.init()` once only, in `main()`."),
    (("__init__() missing", "node_name"), "A node needs a name: `super().__init__('name_of_the_node')`."),
    (("missing", "'qos_profile'"), "The depth is missing: end the brackets with `, 10)`."),
    (("object.__init__() takes exactly one argument",), _NO_NODE),
    (
        ("ParameterAlreadyDeclaredException",),
        "Declare each parameter once, in `__init__`: not in a callback, which runs again and again.",
    ),
    (
        ("InvalidParameterTypeException",),
        "A parameter has the type of its default value: `0.5` is a double, `1` an integer, `'0.5'` a string.",
    ),
    (("in parameters list is not a str",), "It takes a name and a value: `declare_parameter('name', 0.5)`."),
    (("'function' object has no attribute",), _BRACKETS),
    (("'method' object has no attribute",), _BRACKETS),
    (
        ("InvalidNodeName",),
        "A node's name may hold letters, digits and `_`, and does not begin with a digit.",
    ),
    (
        ("InvalidTopicName",),
        "A topic's name may hold letters, digits, `_` and `/`; no part of it begins with a digit.",
    ),
    (
        ("has no attribute '_TYPE_SUPPORT'",),
        "Give the type itself, without quotes: import it from its package first.",
    ),
    (
        ("circular import",),
        "Two files import each other. Move what both need to a third one.",
    ),
    (
        ("SyntaxError",),
        "Python cannot read the file. Look at the line named here, and at the end of the one before.",
    ),
    (("IndentationError",), "Check the spaces at the beginning of this line: four for each level."),
    (("TabError",), "The line begins with a tab, others with spaces. Use four spaces for each level."),
)
# What a node makes in Node.__init__, and misses without it.
_MADE_BY_SUPER = re.compile(
    r"'\w+' object has no attribute '_(Node__\w+|allow_undeclared_parameters|clock|context"
    r"|default_callback_group|descriptors|logger|parameter_overrides|parameters)'"
)
_LOST_SUPER = re.compile(
    r"'\w+' object has no attribute '(create_\w+|declare_parameters?|get_clock|get_logger|get_parameter)'"
)


@dataclass(frozen=True)
class _Remedy:
    advice: str
    where: tuple[Location, ...] = ()


def crash_feedback(found: Crash, packages: BuiltPackages, sources: Sources) -> Feedback:
    """The feedback for a program that stopped with this exception."""
    places = (found.where,) if found.where else ()
    remedy = _remedy(found, packages, sources)
    return Feedback(
        summary=f"The program stopped with an error: {found.error}",
        where=tuple(dict.fromkeys((*remedy.where, *places))),
        advice=remedy.advice,
        details=found.shown,
    )


def _remedy(found: Crash, packages: BuiltPackages, sources: Sources) -> _Remedy:
    return (
        _missing_module(found.error, packages, sources)
        or _missing_function(found.error, packages, sources)
        or _entry_without_function(found.error, packages, sources)
        or _callback_called(found.error, sources)
        or _of_a_cause(undeclared(found.error, sources) or value_forgotten(found.error, sources))
        or _in_a_service(found.error, sources)
        or _before_sas(found.error, sources)
        or _known(found.error)
    )


def _known(error: str) -> _Remedy:
    if _LOST_SUPER.search(error):
        return _Remedy(f"{_NO_NODE} {_SUPER}")
    if _MADE_BY_SUPER.search(error):
        return _Remedy(_SUPER)
    for words, advice in _KNOWN:
        if all(word in error for word in words):
            return _Remedy(advice)
    return _Remedy("Look at the line named here: it is the one of yours that led to the error.")


def _missing_module(error: str, packages: BuiltPackages, sources: Sources) -> _Remedy | None:
    match = _NO_MODULE.search(error)
    if not match:
        return None
    name = match["name"]
    moved = _elsewhere(name, packages, sources)
    if moved:
        text = f"The file is at `{moved[0]}`. Move it to `{moved[1]}`."
        return _Remedy(text, (Location(moved[0]),))
    neighbour = _neighbour(name, packages, sources)
    if neighbour:
        return _Remedy(f"Name its package too: `{neighbour}` in place of `{name}`.")
    entry = _entry_for(name, packages, sources)
    if entry:
        modules = [PurePosixPath(file).stem for file in _modules(entry, packages, sources)]
        text = f"The entry point names a module that does not exist. The package has {listed(modules)}."
        return _Remedy(text, (entry.where,))
    return _Remedy(f"Check the import: is `{name}` spelt right, and does package.xml name its package?")


def _elsewhere(module: str, packages: BuiltPackages, sources: Sources) -> tuple[str, str] | None:
    """Where the module's file is, and where it should be, when it lies in another folder of its package."""
    package = packages.get(module.split(".")[0])
    if package is None:
        return None
    wanted = f"{package.source}/{module.replace('.', '/')}.py"
    name = PurePosixPath(wanted).name
    lost = [file for file in sources.below(package.source).names if PurePosixPath(file).name == name]
    return (lost[0], wanted) if lost and wanted not in lost else None


def _neighbour(module: str, packages: BuiltPackages, sources: Sources) -> str | None:
    """`talk.words`, when the package `talk` has such a module and `words` alone was imported."""
    for package in packages.built:
        path = f"{package.source}/{package.name}/{module.replace('.', '/')}"
        if f"{path}.py" in sources.files or f"{path}/__init__.py" in sources.files:
            return f"{package.name}.{module}"
    return None


def _missing_function(error: str, packages: BuiltPackages, sources: Sources) -> _Remedy | None:
    match = _NO_NAME.search(error)
    if not match:
        return None
    module, name = match["module"] or match["module2"], match["name"] or match["name2"]
    entry = _entry_for(module, packages, sources)
    if entry is None:
        return _Remedy(f"`{module}` has nothing called `{name}`. Check the spelling of both.")
    functions = _functions(sources, module)
    return _Remedy(
        f"The entry point names the function `{name}`; `{module}` has {listed(functions)}.", (entry.where,)
    )


def _entry_without_function(error: str, packages: BuiltPackages, sources: Sources) -> _Remedy | None:
    if "'module' object is not callable" not in error:
        return None
    bare = [entry for entry in _entries(packages, sources) if ":" not in entry.target]
    if not bare:
        return None
    return _Remedy(
        f"The entry point names a module and no function in it: end it with `:main`, `{bare[0].text}:main`.",
        (bare[0].where,),
    )


def _callback_called(error: str, sources: Sources) -> _Remedy | None:
    if "NoneType" not in error and "callable" not in error:
        return None
    return _of_a_cause(called_callback(sources))


def _in_a_service(error: str, sources: Sources) -> _Remedy | None:
    """rclpy raises a bare TypeError when the callback of a server returns no response."""
    if error == "TypeError":
        return _of_a_cause(no_response(sources) or not_the_response(sources))
    if _ON_THE_REQUEST.search(error):
        return _of_a_cause(fields_of_the_request(sources))
    if "'NoneType' object has no attribute" in error:
        return _of_a_cause(result_too_early(sources))
    return None


def _before_sas(error: str, sources: Sources) -> _Remedy | None:
    """A client of the SmartArmStack starts ROS by a name of its own, and rclpy's words do not say so."""
    if not any(words in error for words in _NOT_STARTED):
        return None
    is_of_sas = any("rclcpp_Node" in text for file, text in sources.files.items() if file.endswith(".py"))
    return _Remedy(_INIT_OF_SAS) if is_of_sas else None


def _of_a_cause(cause: Cause | None) -> _Remedy | None:
    return _Remedy(cause.text, cause.where) if cause else None


def _entries(packages: BuiltPackages, sources: Sources) -> tuple[EntryPoint, ...]:
    return tuple(entry for package in packages.built for entry in entry_points(sources, package.source))


def _entry_for(module: str, packages: BuiltPackages, sources: Sources) -> EntryPoint | None:
    """The entry point that leads to this module, or to one inside it."""
    for entry in _entries(packages, sources):
        target = entry.target.split(":")[0].strip()
        if f"{target}.".startswith(f"{module}."):
            return entry
    return None


def _modules(entry: EntryPoint, packages: BuiltPackages, sources: Sources) -> list[str]:
    """Files of the Python package that the entry point names."""
    folders = [f"{package.source}/{entry.target.split('.')[0]}" for package in packages.built]
    found = (file for folder in folders for file in sources.below(folder).files)
    return [file for file in found if file.endswith(".py") and not file.endswith("/__init__.py")]


def _functions(sources: Sources, module: str) -> list[str]:
    wanted = f"/{module.replace('.', '/')}.py"
    trees = (parsed(text) for file, text in sources.files.items() if file.endswith(wanted))
    tree = next((tree for tree in trees if tree is not None), None)
    return [node.name for node in tree.body if isinstance(node, ast.FunctionDef)] if tree else []
