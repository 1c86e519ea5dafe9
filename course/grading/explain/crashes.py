"""What a program's exception means for a beginner: the cause and the next step."""

from __future__ import annotations

import ast
import re
from dataclasses import dataclass, replace
from pathlib import PurePosixPath

from course.evidence.packages import BuiltPackages
from course.evidence.sources import Sources
from course.feedback import Feedback, Location
from course.grading.explain.names import listed
from course.grading.explain.setup_py import EntryPoint, entry_points
from course.grading.explain.timers import called_callback
from course.grading.explain.tracebacks import Crash

_NO_MODULE = re.compile(r"No module named '(?P<name>[\w.]+)'")
_NO_NAME = re.compile(
    r"cannot import name '(?P<name>\w+)' from '(?P<module>[\w.]+)'"
    r"|module '(?P<module2>[\w.]+)' has no attribute '(?P<name2>\w+)'"
)
_INIT = "Call `rclpy.init()` at the beginning of `main()`, before the node is made."
_SUPER = "Call `super().__init__('name_of_the_node')` first in the class's `__init__`."
# Words of the exception's line -> what to do. The first that fits is taken.
_KNOWN = (
    (("rclpy.init() has not been called",), _INIT),
    (("NotInitializedException",), _INIT),
    (("__init__() missing", "node_name"), "A node needs a name: `super().__init__('name_of_the_node')`."),
    (
        ("object.__init__() takes exactly one argument",),
        "The class must derive from Node: `class ...(Node):`.",
    ),
    (("has no attribute '_Node__",), _SUPER),
    (("has no attribute '_clock'",), _SUPER),
    (
        ("'function' object has no attribute",),
        "A function is named but not called: `get_logger()` needs its brackets.",
    ),
    (
        ("'method' object has no attribute",),
        "A function is named but not called: `get_logger()` needs its brackets.",
    ),
    (
        ("InvalidNodeName",),
        "A node's name may hold letters, digits and `_`, and does not begin with a digit.",
    ),
    (
        ("SyntaxError",),
        "Python cannot read the file. Look at the line named here, and at the end of the one before.",
    ),
    (("IndentationError",), "Check the spaces at the beginning of this line: four for each level."),
)
_LOST_SUPER = re.compile(
    r"'\w+' object has no attribute '(create_timer|get_logger|create_publisher|create_subscription)'"
)


@dataclass(frozen=True)
class _Remedy:
    advice: str
    where: tuple[Location, ...] = ()


def crash_feedback(found: Crash, packages: BuiltPackages, sources: Sources) -> Feedback:
    """The feedback for a program that stopped with this exception."""
    places = (found.where,) if found.where else ()
    feedback = Feedback(
        summary=f"The program stopped with an error: {found.error}", where=places, details=found.shown
    )
    remedy = _remedy(found, packages, sources)
    return replace(feedback, advice=remedy.advice, where=(*remedy.where, *places))


def _remedy(found: Crash, packages: BuiltPackages, sources: Sources) -> _Remedy:
    return (
        _missing_module(found.error, packages, sources)
        or _missing_function(found.error, packages, sources)
        or _entry_without_function(found.error, packages, sources)
        or _callback_called(found.error, sources)
        or _known(found.error)
    )


def _known(error: str) -> _Remedy:
    if _LOST_SUPER.search(error):
        return _Remedy("The class must derive from Node: `class ...(Node):`. " + _SUPER)
    for words, advice in _KNOWN:
        if all(word in error for word in words):
            return _Remedy(advice)
    return _Remedy(
        "The last line of the traceback names the error; the place is the line of yours that led to it."
    )


def _missing_module(error: str, packages: BuiltPackages, sources: Sources) -> _Remedy | None:
    match = _NO_MODULE.search(error)
    if not match:
        return None
    name = match["name"]
    entry = _entry_for(name, packages, sources)
    wanted = f"{name.replace('.', '/')}.py"
    lost = [file for file in sources.names if PurePosixPath(file).name == PurePosixPath(wanted).name]
    if lost and not any(file.endswith(wanted) for file in lost):
        return _Remedy(
            f"The file lies at `{lost[0]}`; it belongs in `{wanted}`, in the folder within.",
            (Location(lost[0]),),
        )
    if entry:
        modules = [PurePosixPath(file).stem for file in sources.files if _is_module(file, entry, packages)]
        return _Remedy(
            f"The entry point names a module that does not exist. There are {listed(modules)}.",
            (entry.where,),
        )
    return _Remedy(f"Check the import: is `{name}` spelt right, and does package.xml name its package?")


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
    cause = called_callback(sources)
    return _Remedy(cause.text, cause.where) if cause else None


def _entries(packages: BuiltPackages, sources: Sources) -> tuple[EntryPoint, ...]:
    return tuple(entry for package in packages.built for entry in entry_points(sources, package.source))


def _entry_for(module: str, packages: BuiltPackages, sources: Sources) -> EntryPoint | None:
    return next((e for e in _entries(packages, sources) if e.target.split(":")[0].strip() == module), None)


def _is_module(file: str, entry: EntryPoint, packages: BuiltPackages) -> bool:
    folder = entry.target.split(".")[0]
    path = PurePosixPath(file)
    return path.suffix == ".py" and path.parent.name == folder and path.name != "__init__.py"


def _functions(sources: Sources, module: str) -> list[str]:
    wanted = f"{module.replace('.', '/')}.py"
    for file, text in sources.files.items():
        if file.endswith(wanted):
            return [node.name for node in ast.parse(text).body if isinstance(node, ast.FunctionDef)]
    return []
