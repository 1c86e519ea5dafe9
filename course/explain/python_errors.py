"""A Python program's exception: its traceback, reduced to what the learner needs, and known errors."""

from __future__ import annotations

import ast
import builtins
import posixpath
import re
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import PurePosixPath

from course.evidence.packages import BuiltPackages
from course.evidence.sources import Sources
from course.explain.callbacks import callbacks, called_callback, passed
from course.explain.engine import (
    Cause,
    Evidence,
    Known,
    Proof,
    Proven,
    Symptom,
    Words,
    because,
    explain,
    here,
)
from course.explain.parameter_causes import undeclared, value_forgotten
from course.explain.python_code import (
    assigned,
    called_name,
    calls,
    functions,
    last_name,
    nodes,
    number,
    parsed,
    takes_self,
)
from course.explain.python_mixups import MIXUPS
from course.explain.python_slips import (
    accidental_tuple,
    assigned_backward,
    class_spun,
    misnamed_constructor,
    missing_sign,
    shadowed_import,
    uncalled,
    waits_for_input,
)
from course.explain.service_causes import (
    fields_of_the_request,
    no_response,
    not_the_response,
    result_too_early,
)
from course.explain.setup_py import EntryPoint, entry_points, packages_place
from course.model.feedback import Feedback, Location
from course.spelling import LOOSELY, listed, nearest

_ERROR_LINES = 2
_PYTHON_PACKAGES = ("site-packages", "dist-packages")
_FRAME = re.compile(r'^\s*File "(?P<file>[^"]+)", line (?P<line>\d+)')


@dataclass(frozen=True)
class Crash:
    """error: the line that names the exception. where: the learner's innermost line. shown: key lines."""

    error: str
    where: Location | None
    shown: tuple[str, ...]


def crash(traceback: tuple[str, ...], packages: BuiltPackages, sources: Sources) -> Crash | None:
    """Return what this traceback says; None if it is empty."""
    if not traceback:
        return None
    traceback = tuple(line.partition(f" {_ROS_1}")[0] for line in traceback)  # never the cause here
    places = [place for place in (_place(line, packages, sources) for line in traceback) if place]
    where = places[-1] if places else None
    start = _error_start(traceback)
    error = " ".join(line.strip() for line in traceback[start : start + _ERROR_LINES] if line.strip(" ^"))
    place = f"{where.file}, line {where.line}:" if where else None
    shown = tuple(line for line in (place, _code_line(where, sources), *traceback[start:]) if line)
    return Crash(error, where, shown)


def _error_start(traceback: tuple[str, ...]) -> int:
    """Index of the line that names the exception: the last one that is not indented."""
    flush = [index for index, line in enumerate(traceback) if line and not line.startswith((" ", "\t"))]
    words = [index for index, line in enumerate(traceback) if any(map(str.isalpha, line))]
    return (flush or words or [0])[-1]  # in an exception group, all lines are indented


def _place(line: str, packages: BuiltPackages, sources: Sources) -> Location | None:
    frame = _FRAME.match(line)
    if not frame:
        return None
    file = learners_file(frame["file"], packages, sources)
    return Location(file, int(frame["line"])) if file else None


def learners_file(path: str, packages: BuiltPackages, sources: Sources) -> str | None:
    """Return the source of an installed file, relative to the course home; None if there is none."""
    for package in packages.built:
        prefix = package.prefix.rstrip("/") + "/"
        if path.startswith(prefix):
            return _source_of(PurePosixPath(path[len(prefix) :]).parts, package.source, sources)
    return _in_home(path, sources)


def _in_home(path: str, sources: Sources) -> str | None:
    """A script runs in a copy of the home, so its path ends as it does in the home."""
    whole = posixpath.normpath(path)
    found = [name for name in sources.files if whole.endswith(f"/{name}")]
    return max(found, key=len) if found else None


def _source_of(installed: tuple[str, ...], folder: str, sources: Sources) -> str | None:
    """The source of a file installed as lib/python3.12/site-packages/talk/talker.py, or as lib/talk/talker.

    A package may keep its modules in a folder of its own, such as `src`, so the source path may be longer
    than the installed one.
    """
    packages = [index for index, part in enumerate(installed) if part in _PYTHON_PACKAGES]
    tail = "/".join(installed[packages[0] + 1 :] if packages else installed[-1:])
    if f"{folder}/{tail}" in sources.files:
        return f"{folder}/{tail}"
    found = [name for name in sources.below(folder).files if name.endswith(f"/{tail}")]
    return found[0] if len(found) == 1 else None


def _code_line(where: Location | None, sources: Sources) -> str | None:
    if where is None or where.line is None:
        return None
    lines = sources.files[where.file].splitlines()
    return "    " + lines[where.line - 1].strip() if 0 < where.line <= len(lines) else None


def crash_feedback(found: Crash, packages: BuiltPackages, sources: Sources) -> Feedback:
    """Feedback on a program that stopped with this exception."""
    symptom = Symptom(found.error, found.where, found.shown)
    known = explain(EXCEPTIONS, [symptom], Evidence(sources=sources, packages=packages))
    return Feedback(
        summary=f"The program stopped with an error: {found.error}",
        where=known.where if known else (),
        advice=known.remedy if known else None,
        details=found.shown,
    )


# ------------------------------------------------------------------------------------------ proofs


def _moved(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    found = _elsewhere(words["name"], evidence.packages, evidence.sources)
    return Proven({"there": found[0], "wanted": found[1]}, (Location(found[0]),)) if found else None


def _of_a_package(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    neighbor = _neighbor(words["name"], evidence.packages, evidence.sources)
    entry = None if symptom.where else _entry_for(words["name"], evidence.packages, evidence.sources)
    where = entry.where if entry else symptom.where
    return Proven({"neighbor": neighbor}, (where,) if where else ()) if neighbor else None


_MODULES = {"Node": "rclpy.node", "Parameter": "rclpy.parameter", "QoSProfile": "rclpy.qos"}


def _in_its_module(evidence: Evidence, symptom: Symptom, words: Words) -> Proven:
    return Proven({"line": f"from {_MODULES[words['name']]} import {words['name']}"})


def _by_key(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`message['id']`, in the line that the error names, or in the only line with such an expression."""
    found = [(Location(file, node.lineno), node) for file, node in _subscripts(evidence.sources)]
    named = [one for one in found if symptom.where is None or one[0] == symptom.where] or found
    if len({where for where, _ in named}) != 1:
        return None
    where, node = named[0]
    right = f"{ast.unparse(node.value)}.{ast.unparse(node.slice)[1:-1]}"
    return Proven({"wrong": ast.unparse(node), "right": right}, (where,))


def _subscripts(sources: Sources) -> Iterator[tuple[str, ast.Subscript]]:
    """Where a string is used as a key."""
    for file, node in nodes(sources):
        key = node.slice if isinstance(node, ast.Subscript) else None
        if isinstance(node, ast.Subscript) and isinstance(key, ast.Constant) and isinstance(key.value, str):
            yield file, node


def _entry_of_module(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    entry = _entry_for(words["name"], evidence.packages, evidence.sources)
    if entry is None:
        return None
    modules = (PurePosixPath(file).stem for file in _modules(entry, evidence.packages, evidence.sources))
    return Proven({"modules": listed(modules)}, (entry.where,))


def _entry_of_function(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    entry = _entry_for(words["module"], evidence.packages, evidence.sources)
    functions = listed(_functions(evidence.sources, words["module"]))
    return Proven({"functions": functions}, (entry.where,)) if entry else None


def _bare_entry(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    entries = _entries(evidence.packages, evidence.sources)
    bare = next((entry for entry in entries if ":" not in entry.target), None)
    return Proven({"entry": bare.text}, (bare.where,)) if bare else None


def _said(cause: Callable[[str, Sources], Cause | None]) -> Proof[Evidence]:
    """A cause that is found in the learner's files and the exception's text."""

    def proof(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
        return because(lambda sources: cause(symptom.text, sources))(evidence, symptom, words)

    return proof


def _misspelled(evidence: Evidence, symptom: Symptom, words: Words) -> Proven:
    """What the learner defined with nearly the same name."""
    name = words.get("name") or words["plain"]
    every = (node for _, node in nodes(evidence.sources))
    stores = [node for node in every if isinstance(getattr(node, "ctx", None), ast.Store)]
    stored = {node.attr for node in stores if isinstance(node, ast.Attribute)}
    named = {node.id for node in stores if isinstance(node, ast.Name)}
    near = nearest(name, (named if "plain" in words else stored) - {name}, LOOSELY)
    own = {node.name for _, node in nodes(evidence.sources) if isinstance(node, ast.ClassDef)}
    kind = {"own" if words["of"] in own else "foreign": words["of"]} if "of" in words else {}
    return Proven({"name": name, **kind, **({"near": near} if near else {})})


def _ros_calls_it(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """A callback that rclpy calls, but no line of the learner's code."""
    found = [one for one in callbacks(evidence.sources) if one.node.name == words["name"]]
    prepared = [ast.unparse(one) for call in calls(evidence.sources, "partial") for one in call.args[:1]]
    by_own_code = calls(evidence.sources, words["name"]) or words["name"] in prepared
    return None if not found or by_own_code else Proven(where=(found[0].where,))


_PASSED = {
    "create_subscription": ["message"],
    "create_service": ["request", "response"],
    "add_done_callback": ["future"],
}


def _ros_passes_more(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """A callback whose `def` has fewer arguments than ROS passes."""
    proven, name = _ros_calls_it(evidence, symptom, words), words["name"]
    if proven is None:
        return None
    for maker, _, given in passed(evidence.sources):
        own = ["self"] if isinstance(given, ast.Attribute) and given.attr == name else []
        if own or (isinstance(given, ast.Name) and given.id == name):
            right = f"def {name}({', '.join([*own, *_PASSED.get(maker, [])])}):"
            return Proven({"right": right}, proven.where)
    return None


def _own_method(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    return Proven() if any(map(takes_self, functions(evidence.sources, words["name"]))) else None


def _parameters(evidence: Evidence, symptom: Symptom, words: Words) -> Proven:
    """The arguments of the class's constructor, if the class is the learner's."""
    for _, node in nodes(evidence.sources):
        if isinstance(node, ast.ClassDef) and node.name == words["called"]:
            made = (
                part for part in node.body if isinstance(part, ast.FunctionDef) and part.name == "__init__"
            )
            for one in made:
                return Proven({"parameters": listed([part.arg for part in one.args.args[1:]])})
    return Proven()


def _not_imported(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`time.sleep(1)` without `import time`, if there is no variable of that name."""
    name = words["name"]
    values = (node.value for _, node in nodes(evidence.sources) if isinstance(node, ast.Attribute))
    asked = {value.id for value in values if isinstance(value, ast.Name)}
    is_module = name in sys.stdlib_module_names or f"forget to import '{name}'" in symptom.text
    return Proven() if is_module and name in asked and not _given(evidence.sources, name) else None


# The modules to import the tutorial's names from, if no other file imports them.
_HOMES = {
    "rclpy.node": {"Node"},
    "rclpy.executors": {"ExternalShutdownException", "MultiThreadedExecutor", "SingleThreadedExecutor"},
    "rclpy.parameter": {"Parameter"},
    "rclpy.qos": {"QoSProfile"},
    "rcl_interfaces.msg": {"ParameterDescriptor", "SetParametersResult"},
    "launch": {"LaunchDescription"},
}


def _import_left_out(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`Node` without its import, which another of the learner's files contains, or `_HOMES` does."""
    name = words["name"]
    found = [node for _, node in nodes(evidence.sources) if isinstance(node, ast.ImportFrom) and node.module]
    others = [node.module for node in found if any(alias.name == name for alias in node.names)]
    known = [module for module, names in _HOMES.items() if name in names]
    defined = {getattr(node, "name", None) for _, node in nodes(evidence.sources)}
    module = next(iter((*others, *known)), None)
    return Proven({"module": module}) if module and name not in defined else None


def _of_the_object(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """A name that the class defines, or keeps in `self`, without `self.` or the class's name before it."""
    place, name = symptom.where, words["name"]
    for file, owner in nodes(evidence.sources):
        if not (place and place.line and file == place.file and isinstance(owner, ast.ClassDef)):
            continue
        methods = [part for part in owner.body if isinstance(part, ast.FunctionDef)]
        around = next((one for one in methods if one.lineno <= place.line <= (one.end_lineno or 0)), None)
        shared = {part.name for part in methods}
        shared |= {one.id for part in owner.body for one in _stored(part) if isinstance(one, ast.Name)}
        kept = {one.attr for one in _stored(owner) if isinstance(one, ast.Attribute)}
        if around and takes_self(around) and name in shared | kept:
            return Proven({"owner": "self"})
        if around and name in shared:
            return Proven({"owner": owner.name})
    return None


def _argument(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`self.request`, in a function with the argument `request`."""
    place = symptom.where
    for file, node in nodes(evidence.sources):
        if place and place.line and file == place.file and isinstance(node, ast.FunctionDef):
            inside = node.lineno <= place.line <= (node.end_lineno or 0)
            if inside and words["name"] in [one.arg for one in node.args.args[1:]]:
                return Proven({"function": node.name})
    return None


_TEXT_METHODS = {"casefold", "endswith", "join", "lower", "replace", "split", "startswith", "strip", "upper"}


def _of_text(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """A method of strings, called on an object whose class is not the learner's."""
    own = {node.name for _, node in nodes(evidence.sources) if isinstance(node, ast.ClassDef)}
    return Proven() if words["name"] in _TEXT_METHODS and words["of"] not in own else None


def _in_a_class(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`main`, which is indented like the methods of a class in the module."""
    wanted = f"/{words['module'].replace('.', '/')}.py"
    for file, owner in nodes(evidence.sources):
        if file.endswith(wanted) and isinstance(owner, ast.ClassDef):
            for part in owner.body:
                if isinstance(part, ast.FunctionDef) and part.name == words["name"]:
                    return Proven({"owner": owner.name}, (Location(file, part.lineno),))
    return None


def _stored(top: ast.AST) -> Iterator[ast.Name | ast.Attribute]:
    """`x` in `x = 0`, and `self.x` in `self.x = 0`; nothing if `top` itself is a function."""
    for node in ast.walk(top) if not isinstance(top, ast.FunctionDef) else ():
        if isinstance(node, ast.Name | ast.Attribute) and isinstance(node.ctx, ast.Store):
            yield node


def _comma_in_number(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`time.sleep(0,5)`."""
    for file, node in nodes(evidence.sources):
        match node:
            case ast.Call(args=[ast.Constant(value=int(whole)), ast.Constant(value=int(part))]):
                if Location(file, node.lineno) == symptom.where:
                    return Proven({"right": f"{ast.unparse(node.func)}({whole}.{part})"})
    return None


def _function_for_module(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`from time import time`, and then `time.sleep`."""
    for file, node in nodes(evidence.sources):
        if isinstance(node, ast.ImportFrom) and [alias.name for alias in node.names] == [node.module]:
            used = (one for _, one in nodes(evidence.sources) if isinstance(one, ast.Attribute))
            if any(ast.unparse(one) == f"{node.module}.{words['name']}" for one in used):
                return Proven({"module": str(node.module)}, (Location(file, node.lineno),))
    return None


def _given(sources: Sources, name: str) -> list[Location]:
    """Where a variable of this name is assigned."""
    return [
        Location(file, node.lineno)
        for file, node in nodes(sources)
        if isinstance(node, ast.Name) and node.id == name and isinstance(node.ctx, ast.Store)
    ]


def _given_elsewhere(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    found = _given(evidence.sources, words["name"])
    return Proven(where=(found[0],)) if found else None


def _given_later(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`self.count = 0` is somewhere in the class, but the line that needs it ran first."""
    inside = [
        (file, node)
        for file, owner in nodes(evidence.sources)
        if isinstance(owner, ast.ClassDef) and owner.name == words["of"]
        for node in ast.walk(owner)
    ]
    added = {id(node.target) for _, node in inside if isinstance(node, ast.AugAssign)}
    found = (
        Location(file, node.lineno)
        for file, node in inside
        if isinstance(node, ast.Attribute) and node.attr == words["name"] and id(node) not in added
        if isinstance(node.ctx, ast.Store) and isinstance(node.value, ast.Name) and node.value.id == "self"
    )
    later = [place for place in found if place != symptom.where]
    return Proven(where=(later[0],)) if later else None


def _misplaced(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """A function with this name that is not a method of the class, because of its indentation."""
    for file, owner in nodes(evidence.sources):
        if not isinstance(owner, ast.ClassDef) or owner.name != words["of"]:
            continue
        for method in owner.body:
            inner = ast.walk(method) if isinstance(method, ast.FunctionDef) else ()
            for part in inner:
                if isinstance(part, ast.FunctionDef) and part is not method and part.name == words["name"]:
                    there = f"inside `{getattr(method, 'name', '')}`"
                    return Proven({"there": there}, (Location(file, part.lineno),))
        tree = parsed(evidence.sources.files[file])
        for part in tree.body if tree else ():
            if isinstance(part, ast.FunctionDef) and part.name == words["name"] and takes_self(part):
                return Proven({"there": "outside of the class"}, (Location(file, part.lineno),))
    return None


def _only_local(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`publisher = ...` in a method of the class, where `self.publisher` is asked for."""
    for file, owner in nodes(evidence.sources):
        for node in ast.walk(owner) if isinstance(owner, ast.ClassDef) and owner.name == words["of"] else ():
            if isinstance(node, ast.Name) and node.id == words["name"] and isinstance(node.ctx, ast.Store):
                return Proven({"line": str(node.lineno)}, (Location(file, node.lineno),))
    return None


def _hidden_name(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """A name in this line is imported, defined or built in, and a variable of the same name hides it."""
    place = symptom.where
    tree = parsed(evidence.sources.files.get(place.file, "")) if place else None
    if place is None or tree is None:
        return None
    every = list(ast.walk(tree))
    imports = (
        alias for node in every if isinstance(node, ast.Import | ast.ImportFrom) for alias in node.names
    )
    known = {(alias.asname or alias.name).partition(".")[0] for alias in imports}
    known |= {node.name for node in every if isinstance(node, ast.FunctionDef | ast.ClassDef)}
    used = [part for node in every for part in _used_in(node) if part.lineno == place.line]
    for name in (part.id for part in used if isinstance(part, ast.Name)):
        stored = (node for node in every if isinstance(node, ast.Name) and node.id == name)
        lines = [node.lineno for node in stored if isinstance(node.ctx, ast.Store)]
        lines += [node.lineno for node in every if isinstance(node, ast.arg) and node.arg == name]
        if lines and (name in known or name in dir(builtins)):
            given = {"hidden": name, "line": str(lines[0])}
            return Proven(given, (Location(place.file, lines[0]),))
    return None


def _used_in(node: ast.AST) -> Iterator[ast.expr]:
    """`time` in `time.sleep` or `time(...)`."""
    if isinstance(node, ast.Attribute):
        yield node.value
    elif isinstance(node, ast.Call):
        yield node.func


def _whole_row(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`message.quote = QUOTES[0]` on this line, where each item of QUOTES is a tuple, a list, or a dict."""
    for file, node in nodes(evidence.sources):
        value = node.value if isinstance(node, ast.Assign) else None
        if isinstance(value, ast.Subscript) and Location(file, value.lineno) == symptom.where:
            rows = assigned(evidence.sources, last_name(value.value))
            for row in (row for one in rows if isinstance(one, ast.List | ast.Tuple) for row in one.elts):
                if isinstance(row, ast.Tuple | ast.List | ast.Dict):
                    of = type(row).__name__.lower()
                    return Proven({"value": ast.unparse(value), "of": of})
    return None


def _text_assigned(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`response.success = 'True'`, on this line."""
    for file, node in nodes(evidence.sources):
        if (
            isinstance(node, ast.Assign)
            and _is_text(node.value)
            and Location(file, node.lineno) == symptom.where
        ):
            return Proven({"text": ast.unparse(node.value)})
    return None


def _swapped(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`create_timer`, `create_publisher` and the like, with the first two arguments swapped."""
    for maker, (first, second) in _ORDER.items():
        for call in calls(evidence.sources, maker):
            one, two = (*call.args, None, None)[:2]
            late = number(evidence.sources, two) is not None if maker == "create_timer" else _is_text(one)
            if late and not _is_text(two) and two and one and call.where == symptom.where:
                given = {"maker": maker, "first": first, "second": second}
                rest = "" if maker == "create_timer" else ", ..."
                return Proven({**given, "right": f"{ast.unparse(two)}, {ast.unparse(one)}{rest}"})
    return None


_TYPE_AND_NAME = ("the type", "the name")
_ORDER = {
    "create_timer": ("the period", "the function"),
    "create_publisher": _TYPE_AND_NAME,
    "create_subscription": _TYPE_AND_NAME,
    "create_service": _TYPE_AND_NAME,
    "create_client": _TYPE_AND_NAME,
}


def _is_text(node: ast.expr | None) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, str)


def _callback_last(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`create_subscription(type, name, 10, callback)`."""
    for call in calls(evidence.sources, "create_subscription"):
        args = call.args[:4]
        if len(args) == 4 and number(evidence.sources, args[2]) is not None and call.where == symptom.where:
            right = ", ".join(ast.unparse(args[place]) for place in (0, 1, 3, 2))
            return Proven({"right": f"create_subscription({right})"})
    return None


def _self_twice(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`super().__init__(self, 'name')`."""
    for call in calls(evidence.sources, "__init__"):
        given = [ast.unparse(one) for one in call.args]
        if given[:1] == ["self"] and call.where == symptom.where:
            return Proven({"right": f"super().__init__({', '.join(given[1:])})"})
    return None


def _object_for_type(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`create_publisher(Quote(), ...)`."""
    for call in (call for maker in list(_ORDER)[1:] for call in calls(evidence.sources, maker)):
        given = call.argument(0, "msg_type")
        if isinstance(given, ast.Call) and not given.args and called_name(given)[:1].isupper():
            return Proven({"object": ast.unparse(given), "type": ast.unparse(given.func)}, (call.where,))
    return None


def _refused(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`SetParametersResult()`, which refuses by default."""
    results = calls(evidence.sources, "SetParametersResult")
    silent = [one.where for one in results if "successful" not in one.keywords]
    return Proven(where=tuple(silent[:1])) if silent else None


def _of_another_type(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`.string_value` of a parameter that is not a string, in the file with the error."""
    for file, node in nodes(evidence.sources):
        found = isinstance(node, ast.Attribute) and node.attr == "string_value"
        if found and symptom.where and symptom.where.file == file:
            return Proven(where=(Location(file, getattr(node, "end_lineno", None)),))
    return None


def _in_the_file(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    found = [name for name in evidence.sources.names if PurePosixPath(name).name == words["base"]]
    return Proven(where=(Location(found[0], int(words["line"])),)) if len(found) == 1 else None


def _colon_in_text(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`quote: A raft: two`, in a YAML file."""
    for file, text in evidence.sources.files.items():
        lines = text.splitlines() if PurePosixPath(file).name == words["base"] else ()
        for place, line in enumerate(lines, 1):
            if re.match(r"\s*\w+:\s+[^\s'\"\[{#|>&*][^#]*:(?:\s|$)", line):
                return Proven(where=(Location(file, place),))
    return None


def _sign_in_file(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    files = evidence.sources.files
    found = missing_sign(
        Sources({one: files[one] for one in files if symptom.where and one == symptom.where.file})
    )
    return Proven({"cause": found.text}, found.where) if found else None


def _plus_plus(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`count++`, on this line."""
    shown = evidence.shown(symptom.where) if symptom.where else ()
    return Proven() if any("++" in line for line in shown) else None


def _near_module(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """A module with nearly the same name in the same package."""
    package, _, last = words["name"].rpartition(".")
    paths = [PurePosixPath(file) for file in evidence.sources.files if file.endswith(".py")]
    beside = {path.stem for path in paths if path.parent.name == package.rpartition(".")[2]}
    near = nearest(last, beside - {last, "__init__"}, LOOSELY) if package else None
    return Proven({"near": f"{package}.{near}"}) if near else None


def _not_installed(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """A folder of the package's sources that setup.py leaves out."""
    name = words["name"]
    package = evidence.packages.get(name.partition(".")[0])
    folder = f"{package.source}/{name.replace('.', '/')}" if package and "." in name else ""
    if package is None or not evidence.sources.below(folder).files:
        return None
    init = {} if f"{folder}/__init__.py" in evidence.sources.files else {"init": f"{folder}/__init__.py"}
    return Proven({"folder": folder, **init}, packages_place(evidence.sources, package.source))


def _no_callback(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`create_service(Type, 'name', 10)`, `create_timer(0.5, 'tick')`."""
    for maker, call, given in passed(evidence.sources):
        if isinstance(given, ast.Constant):
            kind = "text" if isinstance(given.value, str) else "given"
            return Proven({"maker": maker, kind: ast.unparse(given)}, (call.where,))
    return None


def _is_of_sas(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """A client of the SmartArmStack starts ROS itself, and rclpy's message does not mention that."""
    files = evidence.sources.files.items()
    return Proven() if any("rclcpp_Node" in text for file, text in files if file.endswith(".py")) else None


def _elsewhere(module: str, packages: BuiltPackages, sources: Sources) -> tuple[str, str] | None:
    """Where the module's file is, and where it should be, if it is in another folder of its package."""
    package = packages.get(module.split(".")[0])
    if package is None:
        return None
    wanted = f"{package.source}/{module.replace('.', '/')}.py"
    name = PurePosixPath(wanted).name
    lost = [file for file in sources.below(package.source).names if PurePosixPath(file).name == name]
    return (lost[0], wanted) if lost and wanted not in lost else None


def _neighbor(module: str, packages: BuiltPackages, sources: Sources) -> str | None:
    """`talk.words`, if the package `talk` has such a module and only `words` was imported."""
    for package in packages.built:
        path = f"{package.source}/{package.name}/{module.replace('.', '/')}"
        if f"{path}.py" in sources.files or f"{path}/__init__.py" in sources.files:
            return f"{package.name}.{module}"
    return None


def _entries(packages: BuiltPackages, sources: Sources) -> tuple[EntryPoint, ...]:
    return tuple(entry for package in packages.built for entry in entry_points(sources, package.source))


def _entry_for(module: str, packages: BuiltPackages, sources: Sources) -> EntryPoint | None:
    """The entry point for this module, or for one inside it."""
    for entry in _entries(packages, sources):
        target = entry.target.split(":")[0].strip()
        if f"{target}.".startswith(f"{module}."):
            return entry
    return None


def _modules(entry: EntryPoint, packages: BuiltPackages, sources: Sources) -> list[str]:
    """The files of the Python package that the entry point names."""
    folders = [f"{package.source}/{entry.target.split('.')[0]}" for package in packages.built]
    found = (file for folder in folders for file in sources.below(folder).files)
    return [file for file in found if file.endswith(".py") and not file.endswith("/__init__.py")]


def _functions(sources: Sources, module: str) -> list[str]:
    wanted = f"/{module.replace('.', '/')}.py"
    trees = (parsed(text) for file, text in sources.files.items() if file.endswith(wanted))
    tree = next((tree for tree in trees if tree is not None), None)
    return [node.name for node in tree.body if isinstance(node, ast.FunctionDef)] if tree else []


# ------------------------------------------------------------------------------------------ entries

_NO_MODULE = r"No module named '(?P<name>[\w.]+)'"
_NO_NAME = (
    r"cannot import name '(?P<name>\w+)' from '(?P<module>[\w.]+)'",
    r"module '(?P<module>[\w.]+)' has no attribute '(?P<name>\w+)'",
)
_NO_FUNCTION = "The entry point names the function `{name}`, but `{module}` has {functions}. Correct it."
_IN_A_CLASS = (
    "`{name}` is inside the class `{owner}`. Move its `def` to the left margin, with all of its lines."
)
_CLASS_WITH_MAIN = {"talk/talker.py": "class Talker:\n    def main():\n        pass\n"}
_NO_SUCH_NAME = "`{module}` has nothing called `{name}`. Check the spelling of both."
_NOT_STARTED = r"rclpy\.init\(\) has not been called|NotInitializedException"
_SUPER = "Call `super().__init__('name_of_the_node')` first in `__init__` of the class."
_NO_NODE = "The class must derive from Node: `class ...(Node):`."
# What Node.__init__ creates: a node that never calls it lacks these.
_MADE_BY_SUPER = (
    r"'\w+' object has no attribute '_(Node__\w+|allow_undeclared_parameters|clock|context"
    r"|default_callback_group|descriptors|logger|parameter_overrides|parameters)'"
)
_LOST_SUPER = (
    r"'\w+' object has no attribute '(create_\w+|declare_parameters?|get_clock|get_logger|get_parameter)'"
)
_NOT_A_FUNCTION = "TypeError: 'NoneType' object is not callable"
_ENTRY = "setup(entry_points={{'console_scripts': ['talk = {}']}})"
_SERVER = "node.create_service(T, 'x', answer)\ndef answer(request, response):\n    {}\n"

_ROS_1 = "This might be a ROS 1 message type but it should be a ROS 2 message type."

SHUT_DOWN_TWICE = Known[Evidence](
    r"rcl_shutdown already called|Context must be initialized before it can be shutdown",
    "ROS was already shut down, by Ctrl+C or an earlier `rclpy.shutdown()`. Call "
    "`rclpy.try_shutdown()` instead.",
    "RCLError: failed to shutdown: rcl_shutdown already called on the given context",
)

EXCEPTIONS: tuple[Known[Evidence], ...] = (
    *MIXUPS,
    Known(r"__init__\(\)|has no attribute|takes no arguments", "{cause}",
          "TypeError: Node.__init__() missing 1 required positional argument: 'node_name'",
          proof=because(misnamed_constructor),
          given={"talk/talker.py": "class Talker(Node):\n    def _init_(self):\n        pass\n"}),
    Known(r"has no attribute|unexpected keyword", "{cause}",
          "AttributeError: type object 'type' has no attribute '_TYPE_SUPPORT'",
          proof=because(shadowed_import),
          given={"talk/talker.py": "from talk.msg import Quote\nclass Quote(Node):\n    pass\n"}),
    Known(r"'(?P<of>\w+)' object is not subscriptable",
          "A message is not a dict: write `{right}` instead of `{wrong}`.",
          "TypeError: 'Quote' object is not subscriptable", proof=_by_key,
          given={"talk/talker.py": "def heard(message):\n    print(message['id'])\n"}),
    Known(r"\btuple\b|The '\w+' field must be", "{cause}",
          "TypeError: unsupported operand: 'tuple' and 'float'", proof=because(accidental_tuple),
          given={"talk/talker.py": "period = 0.5,\n"}),
    Known(r"module 'rclpy' has no attribute '(?P<name>Node|Parameter|QoSProfile)'",
          "`{name}` is in its own module: write `{line}` at the top, and use `{name}` without `rclpy.`.",
          "AttributeError: module 'rclpy' has no attribute 'Node'", proof=_in_its_module),
    SHUT_DOWN_TWICE,
    Known(r"property|'self'|attribute", "{cause}",
          "TypeError: Node._remove_entity() missing 1 required positional argument: 'self'",
          proof=because(class_spun),
          given={"talk/talker.py": "class Talker(Node):\n    pass\n\nrclpy.spin(Talker)\n"}),
    Known(r"EOFError", "{cause}", "EOFError: EOF when reading a line", proof=because(waits_for_input),
          given={"talk/talker.py": "while True:\n    input()\n"}),
    Known(r"Service classes can not be instantiated",
          "A service has two kinds of messages. Create a request like this: `Trigger.Request()`.",
          "NotImplementedError: Service classes can not be instantiated"),
    Known(r"RcutilsLogger\.\w+\(\) takes 2 positional arguments but \d+ were given",
          "A logger takes a single string, unlike `print`. Put the values into an f-string.",
          "TypeError: RcutilsLogger.info() takes 2 positional arguments but 3 were given"),
    Known(r"rclpy_logging_rcutils_log\(\): incompatible function arguments",
          "A logger takes a string. Convert the value: use `str(value)` or an f-string.",
          "TypeError: rclpy_logging_rcutils_log(): incompatible function arguments."),
    Known(r"'\w+' object has no attribute", "{cause}",
          "AttributeError: 'Talker' object has no attribute 'name'", proof=because(assigned_backward),
          given={"talk/talker.py": "class Talker:\n    def __init__(self, name):\n"
                                   "        name = self.name  # here\n"}),
    Known(r"'\w+' object has no attribute '(?P<name>\w+)'",
          "`{name}` is an argument of `{function}`, not part of the object: write it without `self.`.",
          "AttributeError: 'Talker' object has no attribute 'text'", proof=_argument,
          given={"talk/talker.py": "class Talker:\n    def say(self, text):\n        self.text  # here\n"}),
    Known(r"'(?P<of>[A-Z]\w*)' object has no attribute '(?P<name>\w+)'",
          "`{name}` is a method of a string, but this is a whole `{of}`. Use it on a field that is a string.",
          "AttributeError: 'Quote' object has no attribute 'lower'", proof=_of_text),
    Known(r"'(?P<of>\w+)' object has no attribute '(?P<name>\w+)'",
          "`{name}` is defined {there}, so it is not a method of `{of}`. Indent its `def` like "
          "`def __init__`.",
          "AttributeError: 'Talker' object has no attribute 'tick'", proof=_misplaced, where=(here,),
          given={"talk/talker.py": "class Talker(Node):\n    pass\n\ndef tick(self):\n    pass\n"}),
    Known(r"object has no attribute|object is not callable|(?:access|referenced).* variable",
          "Line {line} gives the name `{hidden}` to something else, which hides the original "
          "`{hidden}`. Choose a different name on line {line}.",
          "AttributeError: 'float' object has no attribute 'sleep'", proof=_hidden_name, where=(here,),
          given={"talk/talker.py": "import time; time = 0.5; time.sleep(time)\n"}),
    Known(r"float\(\) argument must be|_TYPE_SUPPORT|incompatible function arguments|is not valid|msg_type",
          "`{maker}` takes {first} first, and then {second}: `{maker}({right})`.",
          "TypeError: float() argument must be a string or a real number, not 'function'", proof=_swapped,
          given={"talk/talker.py": "timer = node.create_timer(tick, 0.5)\n"}),
    Known(r"Expected QoSProfile or int",
          "The callback comes before the queue depth: `{right}`.",
          "TypeError: Expected QoSProfile or int, but received <class 'method'>", proof=_callback_last,
          given={"talk/talker.py": "node.create_subscription(Quote, 'quotes', 10, node.heard)\n"}),
    Known(r"__init__\(\) takes \d+ positional arguments? but \d+ were given",
          "`super()` passes `self` automatically. Leave it out: `{right}`.",
          "TypeError: Node.__init__() takes 2 positional arguments but 3 were given", proof=_self_twice,
          given={"talk/talker.py": "super().__init__(self, 'talker')\n"}),
    Known(r"isinstance\(\) arg 2|_TYPE_SUPPORT|is not valid",
          "`{object}` creates an object. Pass the type itself, without parentheses: `{type}`.",
          "TypeError: isinstance() arg 2 must be a type", proof=_object_for_type, where=(here,),
          given={"talk/talker.py": "node.create_publisher(Quote(), 'quotes', 10)\n"}),
    Known(r"Couldn't parse params file: '--params-file (?:\S*/)?(?P<base>[^/']+)'.*? at line (?P<line>\d+)",
          "ROS cannot read line {line} of `{base}`. The name of the node comes first, `ros__parameters:` "
          "on the next line, and then the parameters. Indent each level by two more spaces.",
          "RCLError: Couldn't parse params file: '--params-file /x/talk.yaml'. Error: Cannot have a value "
          "before ros__parameters at line 2", proof=_in_the_file, given={"talk.yaml": "a:\nb: 1\n"}),
    Known(r"InvalidParameterValueException",
          "A callback of `add_on_set_parameters_callback` refuses the value, because a "
          "`SetParametersResult` reports failure by default. Write `SetParametersResult(successful=True)`.",
          "rclpy.exceptions.InvalidParameterValueException: Invalid parameter value (0.5) for parameter.",
          proof=_refused, given={"talk/talker.py": "def check(new):\n    return SetParametersResult()\n"}),
    Known(r"Couldn't parse params file: '--params-file (?:\S*/)?(?P<base>[^/']+)'.*? near line (?P<line>\d+)",
          "ROS cannot read `{base}`: this text has a `:` in it, so it needs quotation marks around it.",
          "RCLError: Couldn't parse params file: '--params-file /x/talk.yaml'. Error: Error parsing a event "
          "near line 1", proof=_colon_in_text, given={"talk.yaml": "quote: A raft: two\n"}),
    Known(r"could not convert string to float: ''|invalid literal for int\(\) with base 10: ''",
          "`string_value` is empty, because the parameter is a number: read its `double_value` or "
          "`integer_value`.", "ValueError: could not convert string to float: ''", proof=_of_another_type,
          where=(here,), given={"talk/talker.py": "period = float(given.string_value)\n"}),
    Known(_NO_MODULE, "The file is at `{there}`. Move it to `{wanted}`.",
          "ModuleNotFoundError: No module named 'talk.lost'", proof=_moved, where=(here,),
          given={"lost.py": ""}),
    Known(_NO_MODULE, "Include its package in the name: `{neighbor}` instead of `{name}`.",
          "ModuleNotFoundError: No module named 'helper'", proof=_of_a_package,
          given={"talk/helper.py": ""}),
    Known(_NO_MODULE, "The entry point names a missing module. Correct it: the package has {modules}.",
          "ModuleNotFoundError: No module named 'talk.tolker'", proof=_entry_of_module, where=(here,),
          given={"setup.py": _ENTRY.format("talk.tolker:main"), "talk/talker.py": ""}),
    Known(_NO_MODULE, "There is no module `{name}`, but there is `{near}`: correct the import.",
          "ModuleNotFoundError: No module named 'talk.helpr'", proof=_near_module, where=(here,),
          given={"talk/helper.py": ""}),
    Known(_NO_MODULE, ("Create `{init}`: without it, the folder is not installed. The file may be empty.",
          "`{folder}` is not installed. In setup.py, write `packages=find_packages(exclude=['test'])`."),
          "ModuleNotFoundError: No module named 'talk.words'", proof=_not_installed, where=(here,),
          given={"talk/words/__init__.py": "", "setup.py": "setup(packages=['talk'])"}),
    Known(_NO_MODULE, "Check the import: is `{name}` spelled right, and does package.xml name its package?",
          "ModuleNotFoundError: No module named 'std_msg'"),
    Known(_NO_NAME[0], _IN_A_CLASS, "ImportError: cannot import name 'main' from 'talk.talker'",
          proof=_in_a_class, where=(here,), given=_CLASS_WITH_MAIN),
    Known(_NO_NAME[1], _IN_A_CLASS, "AttributeError: module 'talk.talker' has no attribute 'main'",
          proof=_in_a_class, where=(here,), given=_CLASS_WITH_MAIN),
    Known(_NO_NAME[0], _NO_FUNCTION, "ImportError: cannot import name 'mian' from 'talk.talker'",
          proof=_entry_of_function, where=(here,),
          given={"setup.py": _ENTRY.format("talk.talker:mian"), "talk/talker.py": "def main(): pass"}),
    Known(_NO_NAME[1], _NO_FUNCTION, "AttributeError: module 'talk.talker' has no attribute 'mian'",
          proof=_entry_of_function, where=(here,),
          given={"setup.py": _ENTRY.format("talk.talker:mian"), "talk/talker.py": "def main(): pass"}),
    Known(r"cannot import name '(?P<name>[A-Z]\w*)' from '(?P<package>\w+_(?:msgs|srvs|interfaces))'",
          "Messages are in `{package}.msg`, services in `{package}.srv`: write one of them after `from`.",
          "ImportError: cannot import name 'Range' from 'sensor_msgs' (/ros/sensor_msgs/__init__.py)"),
    Known(r"cannot import name '(?P<name>[A-Z]\w*)' from '(?P<package>\w+)\.(?P<kind>msg|srv)'",
          "`{package}.{kind}` has nothing called `{name}`. Check the spelling. Messages are in "
          "`{package}.msg`, and services in `{package}.srv`.",
          "ImportError: cannot import name 'Strin' from 'std_msgs.msg'"),
    Known(_NO_NAME[0], _NO_SUCH_NAME, "ImportError: cannot import name 'Nod' from 'rclpy.node'"),
    Known(_NO_NAME[1], _NO_SUCH_NAME, "AttributeError: module 'rclpy' has no attribute 'spinn'"),
    Known(r"'module' object is not callable",
          "The entry point names a module but no function in it. End it with `:main`: `{entry}:main`.",
          "TypeError: 'module' object is not callable", proof=_bare_entry, where=(here,),
          given={"setup.py": _ENTRY.format("talk.talker")}),
    Known(r"NoneType|callable", "{cause}", _NOT_A_FUNCTION, proof=because(called_callback), where=(here,),
          given={"talk/talker.py": "node.create_timer(1, tick())\ndef tick(): pass"}),
    Known(r"ParameterNotDeclaredException", "{cause}",
          "rclpy.exceptions.ParameterNotDeclaredException: ('Invalid access to undeclared parameter(s): x',)",
          proof=_said(undeclared)),
    Known("", "{cause}", "TypeError: unsupported operand: 'int' and not 'Parameter'",
          proof=_said(value_forgotten),
          given={"talk/talker.py": "print(1 + node.get_parameter('x'))"}),
    Known(r"^TypeError$", "{cause}", "TypeError", proof=because(no_response), where=(here,),
          given={"talk/talker.py": _SERVER.format("pass")}),
    Known(r"^TypeError$", "{cause}", "TypeError", proof=because(not_the_response), where=(here,),
          given={"talk/talker.py": _SERVER.format("return request")}),
    Known(r"'\w+_Request' object has no attribute", "{cause}",
          "AttributeError: 'Ask_Request' object has no attribute 'answer'",
          proof=because(fields_of_the_request), where=(here,),
          given={"talk/talker.py": _SERVER.format("request.answer = 1")}),
    Known(r"'NoneType' object has no attribute", "{cause}",
          "AttributeError: 'NoneType' object has no attribute 'sum'",
          proof=because(result_too_early), where=(here,),
          given={"talk/talker.py": "future.result().sum"}),
    Known(r"Spin the node until is_enabled", "{cause}",
          "RuntimeError: nothing has come yet. Spin the node until is_enabled() is true.",
          proof=because(uncalled), given={"talk/client.py": "while not robot.is_enabled:\n    pass\n"}),
    Known(_NOT_STARTED,
          "Call `rclcpp_init()` of `sas_common` first, before `rclcpp_Node(...)` creates the node.",
          "rclpy.exceptions.NotInitializedException: rclpy.init() has not been called.", proof=_is_of_sas,
          given={"talk/client.py": "node = rclcpp_Node('client')"}),
    Known(_LOST_SUPER, f"{_NO_NODE} {_SUPER}",
          "AttributeError: 'Talker' object has no attribute 'declare_parameter'"),
    Known(_MADE_BY_SUPER, _SUPER, "AttributeError: 'Talker' object has no attribute '_Node__handle'"),
    Known(_NOT_STARTED, "Call `rclpy.init()` at the beginning of `main()`, before the node is created.",
          "rclpy.exceptions.NotInitializedException: cannot create node"),
    Known(r"Context\.init\(\) must only be called once", "Call `rclpy.init()` only once, in `main()`.",
          "RuntimeError: Context.init() must only be called once"),
    Known(r"__init__\(\) missing.*node_name", "A node needs a name: `super().__init__('name_of_the_node')`.",
          "TypeError: Node.__init__() missing 1 required positional argument: 'node_name'"),
    Known(r"missing.*'qos_profile'", "The queue depth is missing: add it as the last argument, `, 10)`.",
          "TypeError: Node.create_publisher() missing 1 required positional argument: 'qos_profile'"),
    Known(r"object\.__init__\(\) takes exactly one argument", _NO_NODE,
          "TypeError: object.__init__() takes exactly one argument (the instance to initialize)"),
    Known(r"ParameterAlreadyDeclaredException",
          "Declare each parameter once, in `__init__`, not in a callback, which runs many times.",
          "rclpy.exceptions.ParameterAlreadyDeclaredException: Parameter(s) already declared: ['x']"),
    Known(r"InvalidParameterTypeException",
          "A parameter has the type of its default value: `0.5` is a double, `1` an integer, `'0.5'` a "
          "string.",
          "rclpy.exceptions.InvalidParameterTypeException: Trying to set parameter 'x' to '1' of type"),
    Known(r"in parameters list is not a str",
          "It takes a name and a value: `declare_parameter('name', 0.5)`.",
          "TypeError: First element 1 at index 0 in parameters list is not a str."),
    Known(r"'(?:function|method)' object has no attribute",
          "A function is named but not called: its parentheses are missing.",
          "AttributeError: 'method' object has no attribute 'info'"),
    Known(r"InvalidNodeName",
          "A node's name may contain only letters, digits, and `_`, and must not begin with a digit.",
          "rclpy.exceptions.InvalidNodeNameException: Invalid node name: node name must not contain"),
    Known(r"InvalidTopicName",
          "A topic's name may contain only letters, digits, `_`, and `/`. No part of it may begin "
          "with a digit.",
          "rclpy.exceptions.InvalidTopicNameException: Invalid topic name: topic name token must not start"),
    Known(r"has no attribute '_TYPE_SUPPORT'",
          "Pass the type itself, without quotes. Import it from its package first.",
          "AttributeError: type object 'str' has no attribute '_TYPE_SUPPORT'"),
    Known(r"circular import", "Two files import each other. Move the code that both need to a third file.",
          "ImportError: cannot import (most likely due to a circular import)"),
    Known(r"'property' object (?:has no attribute|is not iterable)",
          "This uses a class instead of an object. Create an object with `()`, as in `Some.Request()`.",
          "AttributeError: 'property' object has no attribute 'quote'"),
    Known(r"'await' outside async function",
          "Write `async` before the `def` of the function that contains this line.",
          "SyntaxError: 'await' outside async function"),
    Known(r"cannot access local variable|local variable '\w+' referenced before",
          "The function assigns to this name, so the name is local. For one of the module, begin with "
          "`global` and the name; for one of an outer function, `nonlocal`; for an attribute, `self.`",
          "UnboundLocalError: cannot access local variable 'count' where it is not associated with a value"),
    Known(r"(?P<of>\w+) index out of range",
          "The {of} has no element with this index: the last one is `len(...) - 1`. `index % len(...)` "
          "starts over at the first.", "IndexError: tuple index out of range"),
    Known(r"The '(?P<field>\w+)' field must be of type",
          "`{value}` is a whole {of}, but the field `{field}` takes one value: choose one of them, as in "
          "`{value}[0]`.", "AssertionError: The 'quote' field must be of type 'str'", proof=_whole_row,
          given={"talk/talker.py": "ROWS = [('a', 'b')]; message.quote = ROWS[0]\n"}),
    Known(r"The '\w+' field must be of type '(?:int|float|bool)'",
          "`{text}` is a string because of its quotation marks. Leave them out.",
          "AssertionError: The 'success' field must be of type 'bool'", proof=_text_assigned,
          given={"talk/talker.py": "response.success = 'True'\n"}),
    Known(r"The '(?P<field>\w+)' field must be of type '(?P<type>int|float|str|bool)'",
          "The field `{field}` takes only the type `{type}`: check what this line assigns to it. Convert a "
          "number or a string with `{type}(...)`. From a list or message, pass only the part that you need.",
          "AssertionError: The 'id' field must be of type 'int'"),
    Known(r"The '(?P<field>\w+)' field must be a sub message of type '(?P<type>\w+)'",
          "The field `{field}` is itself a message. Set one of the fields of this `{type}`, or give it a "
          "whole `{type}(...)`.", "AssertionError: The 'quote' field must be a sub message of type 'Quote'"),
    Known(r"callback should be either be callable with one argument",
          "The callback must take the message: add a parameter, as in `def callback(self, message):`.",
          "RuntimeError: Subscription.__init__(): callback should be either be callable with one argument"),
    Known(r"service type provided is not valid",
          "Pass the type of the service itself: without `.Request` or `.Response`, and without parentheses.",
          "RuntimeError: The service type provided is not valid (<class 'X_Response'>)"),
    Known(r"Expected <class '[^']*?(?P<type>\w+)'>, got <class '[^']*Metaclass_\w+'>",
          "`{type}` is the type. Create a message from it with parentheses: `{type}()`.",
          "TypeError: Expected <class 'talk.msg.Quote'>, got <class 'talk.msg.Metaclass_Quote'>"),
    Known(r"Expected <class '[^']*?(?P<type>\w+)'>, got <class '(?:[^']*\.)?(?P<of>\w+)'>",
          "This takes a message of type `{type}`, not `{of}`. Create one with `{type}()`, and put the value "
          "into one of its fields.",
          "TypeError: Expected <class 'talk.msg._quote.Quote'>, got <class 'str'>"),
    Known(r"must be a string(?:, a bytes-like object)? or a real number, not 'NoneType'",
          "This needs a number, but gets `None`: a value was not set yet, a function returned nothing, or a "
          "parameter was declared without a default value.",
          "TypeError: float() argument must be a string or a real number, not 'NoneType'"),
    Known(r"'(?P<of>int|float|str)' object is not callable",
          ("`{maker}` gets the string `{text}` as its callback. Pass the function itself, without "
           "quotation marks.",
           "`{maker}` gets `{given}` as its callback. Pass a function instead."),
          "TypeError: 'int' object is not callable", proof=_no_callback, where=(here,),
          given={"talk/talker.py": "self.create_service(Trigger, 'tell', 10)"}),
    Known(r"'(?P<of>int|float|str|bool|list|dict|tuple)' object is not callable",
          "The parentheses try to call a value of type `{of}`. If it is a property or an attribute, "
          "remove them.", "TypeError: 'int' object is not callable"),
    Known(r"unsupported format string passed to (?:builtin_function_or_method|method|function)",
          "The value to format is a function that is named, but not called: its parentheses are missing.",
          "TypeError: unsupported format string passed to builtin_function_or_method.__format__"),
    Known(r"argument of type '(?:builtin_function_or_method|method|function)'",
          "The function after `in` is named, but not called: add its parentheses, as in `.lower()`.",
          "TypeError: argument of type 'builtin_function_or_method' is not iterable"),
    Known(r"argument of type '(?P<of>\w+)' is not (?:iterable|a container)",
          "`in` cannot search a `{of}` object. Search one of its fields: a string or a list.",
          "TypeError: argument of type 'Quote' is not iterable"),
    Known(r"(?P<called>\w+)\.__init__\(\) got an unexpected keyword argument '(?P<name>\w+)'",
          ("`{called}` has no argument `{name}`. It has {parameters}.",
           "`{called}` has no argument `{name}`."),
          "TypeError: Sample.__init__() got an unexpected keyword argument 'nam'", proof=_parameters,
          given={"talk/talker.py": "class Sample:\n    def __init__(self, name):\n        pass\n"}),
    Known(r"got an unexpected keyword argument '(?P<name>\w+)'",
          "The function called here has no argument `{name}`: compare the call with its definition.",
          "TypeError: say() got an unexpected keyword argument 'nam'"),
    Known(r"RecursionError|maximum recursion depth",
          "The function or property that contains this line calls itself forever. Use the "
          "attribute or function that has the value.", "RecursionError: maximum recursion depth exceeded"),
    Known(r"'(?P<of>\w+)' object is not an iterator",
          "`next` needs an iterator, such as `itertools.count()`, but this is of type `{of}`. Store the "
          "iterator itself, not a value from it.", "TypeError: 'int' object is not an iterator"),
    Known(r"missing \d+ required positional arguments?: 'self'",
          "The method is called on the class. Call it on an object of the class.",
          "TypeError: Sample.get_name() missing 1 required positional argument: 'self'"),
    Known(r"\b(?P<name>\w+)\(\) missing \d+ required positional arguments?: (?P<lost>.*)",
          "ROS calls `{name}` without {lost}: remove it from the `def`.",
          "TypeError: Talker.tick() missing 1 required positional argument: 'event'", proof=_ros_calls_it,
          given={"talk/talker.py": "node.create_timer(1, tick)\ndef tick(event):\n    pass\n"}),
    Known(r"\b(?P<name>\w+)\(\) missing \d+ required (?:positional|keyword-only) arguments?: (?P<lost>.*)",
          "`{name}` needs more arguments than it gets here: {lost}. Compare the call with its `def`.",
          "TypeError: Talker.say() missing 1 required positional argument: 'text'"),
    Known(r"await wasn't used with future|type (?:_asyncio\.)?(?:Task|coroutine|Future) doesn't"
          r"|'(?:coroutine|_asyncio\.Future|_GatheringFuture|Task)' object",
          "Put `await` before this call or task. Without it, the program does not wait for the result.",
          "RuntimeError: await wasn't used with future"),
    Known(r"'(?P<of>Future)' object has no attribute '(?P<name>\w+)'",
          "This is a future, not the answer: `call_async` returns it immediately. In an `async def`, write "
          "`await` before the call. Elsewhere, wait until `done()`, and take `result().{name}`.",
          "AttributeError: 'Future' object has no attribute 'point'"),
    Known(r"InvalidStateError", "{cause}", "asyncio.exceptions.InvalidStateError: Result is not set.",
          proof=because(called_callback), where=(here,),
          given={"talk/talker.py": "task.add_done_callback(told(task))\ndef told(task): print(task)"}),
    Known(r"object (?P<of>[\w.]+) can't be used in 'await' expression",
          "`await` cannot wait for a `{of}`. Remove `await`, or await a coroutine, a task, or a future.",
          "TypeError: object NoneType can't be used in 'await' expression"),
    Known(r"unsupported operand type\(s\) for (?P<sign>\S+): '(?P<left>[^']+)' and '(?P<right>[^']+)'",
          "`{sign}` does not work with the types `{left}` and `{right}`. Convert one of the values, or "
          "find out why it has this type.",
          "TypeError: unsupported operand type(s) for +: 'int' and 'str'"),
    Known(r"not supported between instances of '(?P<left>\w+)' and '(?P<right>\w+)'",
          "Python cannot compare the types `{left}` and `{right}`: convert one of the values first.",
          "TypeError: '<' not supported between instances of 'str' and 'int'"),
    Known(r"cannot unpack non-iterable (?P<of>\w+)|'(?P<it>\w+)' object is not iterable",
          ("This needs several values, such as a list or a tuple, but it gets a single `{of}`.",
           "This needs several values, such as a list or a tuple, but it gets a single `{it}`."),
          "TypeError: 'int' object is not iterable"),
    Known(r"(?:too many|not enough) values to unpack",
          "There must be as many names before the `=` as there are values after it.",
          "ValueError: too many values to unpack (expected 2)"),
    Known(r"KeyError: (?P<key>.+)", "The dict has no key {key}: print its keys, and compare the spelling.",
          "KeyError: 'qoute'"),
    Known(r"SyntaxError: f-string: (?:unmatched|expecting)",
          "A quote in the braces ends this f-string too early: it must differ from the quotes around the "
          "string. A field of a message needs no quotes: `message.field`.",
          "SyntaxError: f-string: unmatched '['"),
    Known(r"SyntaxError", "{cause}", "SyntaxError: invalid syntax. Perhaps you forgot a comma?",
          proof=_sign_in_file, given={"talk/talker.py": "words = [\n    'a'\n    2,\n]\n"}),
    Known(r"SyntaxError", "Python has no `++`. Add one with `+= 1`.", "SyntaxError: invalid syntax",
          proof=_plus_plus, given={"talk/talker.py": "count++\n"}),
    Known(r"SyntaxError",
          "Python cannot read the file. Check this line and the end of the line before it.",
          "SyntaxError: invalid syntax"),
    Known(r"IndentationError", "Check the spaces at the beginning of this line: use four for each level.",
          "IndentationError: unexpected indent"),
    Known(r"TabError",
          "This line begins with a tab, other lines with spaces. Use four spaces for each level.",
          "TabError: inconsistent use of tabs and spaces in indentation"),
    Known(r"\b(?P<name>\w+)\(\) takes .*positional arguments? but \d+ (?:was|were) given",
          "ROS passes more arguments to `{name}` than it takes: write `{right}`.",
          "TypeError: Talker.hear() takes 1 positional argument but 2 were given", proof=_ros_passes_more,
          given={"talk/talker.py": "create_subscription(Text, 'a', self.hear)\ndef hear(self):\n    pass\n"}),
    Known(r"\b(?P<name>\w+)\(\) takes .*positional arguments? but \d+ (?:was|were) given",
          "Compare this call with `def {name}(...)`, which takes fewer arguments. `self` counts as one.",
          "TypeError: Talker.say() takes 1 positional argument but 2 were given", proof=_own_method,
          where=(here,), given={"talk/talker.py": "class Talker:\n    def say(self):\n        pass\n"}),
    Known(r"\b(?P<name>\w+)\(\) takes .*positional arguments? but \d+ (?:was|were) given",
          "This call passes more arguments to `{name}` than it takes. Remove one, or pass it by its name, "
          "as in `name=value`.", "TypeError: say() takes 1 positional argument but 2 were given"),
    Known(r'can only concatenate str \(not "(?:int|float)"',
          "This line adds a number to a string: use an f-string.",
          'TypeError: can only concatenate str (not "int") to str'),
    Known(r'can only concatenate str \(not "NoneType"',
          "This line adds `None` to a string: a value was not set yet, or a function returned nothing.",
          'TypeError: can only concatenate str (not "NoneType") to str'),
    Known(r'can only concatenate str \(not "(?P<type>[\w.]+)"',
          "This line adds a `{type}` to a string: use an f-string.",
          'TypeError: can only concatenate str (not "list") to str'),
    Known(r"'NoneType' object has no attribute '(?P<name>\w+)'",
          "The object before `.{name}` is `None` here: it has no value yet, or a function returned nothing.",
          "AttributeError: 'NoneType' object has no attribute 'info'"),
    Known(r"name '(?P<name>\w+)' is not defined", "Add `import {name}` at the top of the file.",
          "NameError: name 'time' is not defined", proof=_not_imported,
          given={"talk/talker.py": "timer = 1\ntime.sleep(timer)\n"}),
    Known(r"name '(?P<name>\w+)' is not defined", "Add `from {module} import {name}` at the top of the file.",
          "NameError: name 'Node' is not defined", proof=_import_left_out,
          given={"talk/talker.py": "class Talker(Node):\n    pass\n"}),
    Known(r"name '(?P<name>\w+)' is not defined",
          "`{name}` belongs to the object or its class: write `{owner}.{name}`.",
          "NameError: name 'tick' is not defined", proof=_of_the_object,
          given={"talk/talker.py": "class Talker:\n    def tick(self):\n        print(tick)  # here\n"}),
    Known(r"takes exactly one argument \(2 given\)", "Write numbers with a decimal point: `{right}`.",
          "TypeError: time.sleep() takes exactly one argument (2 given)", proof=_comma_in_number,
          given={"talk/talker.py": "time.sleep(0,5)\n"}),
    Known(r"'builtin_function_or_method' object has no attribute '(?P<name>\w+)'",
          "This imports the function `{module}`, not the module. Write `import {module}` instead.",
          "AttributeError: 'builtin_function_or_method' object has no attribute 'sleep'",
          proof=_function_for_module, where=(here,),
          given={"talk/talker.py": "from time import time\ntime.sleep(1)\n"}),
    Known(r"name '(?P<name>\w+)' is not defined",
          "`{name}` gets its value elsewhere, or only later. Set it earlier, or pass it as an argument.",
          "NameError: name 'count' is not defined", proof=_given_elsewhere, where=(here,),
          given={"talk/talker.py": "print(count)\n\ndef main():\n    count = 0\n"}),
    Known(r"'(?P<of>\w+)' object has no attribute '(?P<name>\w+)'",
          "`{name}` on line {line} is a variable of that function only. Write `self.{name}` there, too.",
          "AttributeError: 'Talker' object has no attribute 'publisher'", proof=_only_local, where=(here,),
          given={"talk/talker.py": "class Talker(Node):\n    def __init__(self):\n        publisher = 0\n"}),
    Known(r"'(?P<of>\w+)' object has no attribute '(?P<name>\w+)'",
          "`{name}` gets its value only after this line runs. Set it earlier.",
          "AttributeError: 'Talker' object has no attribute 'count'", proof=_given_later, where=(here,),
          given={"talk/talker.py": "class Talker(Node):\n    def __init__(self):\n        self.count = 0\n"}),
    Known(r"(?:'(?P<of>\w+)' object )?has no attribute '(?P<name>\w+)'|name '(?P<plain>\w+)' is not defined",
          ("You probably mean `{near}`.",
           "The object before `.{name}` is of type `{foreign}`, which has no `{name}`. Is it the "
           "object that you mean, and is the name spelled right?",
           "Nothing in `{own}` sets `self.{name}`. Set it in `__init__`, or correct the name.",
           "Check the spelling of `{name}`, or import it: nothing with that name exists here."),
          "AttributeError: 'Talker' object has no attribute 'cuont'", proof=_misspelled,
          given={"talk/talker.py": "self.count = 0\n"}),
    Known("", "The program failed while it ran this line. The mistake may be elsewhere: read the message.",
          "ValueError: something of the program's own"),
)  # fmt: skip

# Entries that prove their cause in the code. The others only explain the text of the exception.
PROVEN = tuple(one for one in EXCEPTIONS if one.proof not in (None, _misspelled, _parameters))
