"""Why a launch file does not do what it should, based on the file itself and on setup.py."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from fnmatch import fnmatch
from pathlib import PurePosixPath
from typing import TypeGuard

from course.evidence.packages import BuiltPackages
from course.evidence.sources import Sources
from course.explain.cmake import LISTS
from course.explain.engine import Cause
from course.explain.python_code import PythonCall, called_name, calls, nodes, parsed
from course.model.feedback import Feedback, Location
from course.spelling import LOOSELY, listed, nearest

_ENDINGS = ("launch.py", "launch.xml", "launch.yaml")


def not_installed(sources: Sources, folder: str, file: str) -> Feedback:
    """Why `ros2 launch` does not find `file` in the package in this folder of the course home."""
    setup = f"{folder}/setup.py"
    there = [name for name in sources.below(folder).names if name.endswith("launch.py") or "/launch/" in name]
    path = next((name for name in there if PurePosixPath(name).name == file), None)
    if path is None:
        return _no_such_file(there, folder, file)
    relative = path.removeprefix(f"{folder}/")
    if f"{folder}/{LISTS}" in sources.files:
        return _not_by_cmake(relative, Location(f"{folder}/{LISTS}"))
    patterns = tuple(_patterns(sources, setup))
    if not patterns:
        return Feedback(
            summary=f"`{file}` exists, but it is not installed: `data_files` in setup.py does not name it.",
            expected=f"'{relative}' among the data files",
            where=tuple(_line(sources, setup, "data_files")),
            advice="Add to `data_files`: `('share/' + package_name + '/launch', "
            f"glob('{PurePosixPath(relative).parent}/*launch.py')),` with `from glob import glob` above.",
        )
    if any(fnmatch(relative, pattern) for pattern, _ in patterns):
        return _installed_elsewhere(file, patterns[0][1])
    return _no_match(path, folder, *patterns[0])


def _not_by_cmake(relative: str, lists: Location) -> Feedback:
    """For a package that CMake builds. relative: the launch file, relative to the package's folder."""
    file = PurePosixPath(relative)
    what = f"DIRECTORY {file.parent}" if file.parent != PurePosixPath() else f"FILES {file}"
    return Feedback(
        summary=f"`{file.name}` exists, but {LISTS} does not install it where ROS looks for it.",
        expected="installed into `share/<package>`",
        where=(lists,),
        advice=f"`install({what} DESTINATION share/${{PROJECT_NAME}})`",
    )


def _installed_elsewhere(file: str, where: Location) -> Feedback:
    return Feedback(
        summary=f"`{file}` is not installed where ROS looks for it, `share/<package>`.",
        expected="installed into `share/<package>/launch`",
        where=(where,),
        advice="In `data_files`, the first part is the folder to install into: "
        "`'share/' + package_name + '/launch'`.",
    )


def _no_match(path: str, folder: str, pattern: str, where: Location) -> Feedback:
    """A file next to setup.py should move to where the pattern looks; otherwise the pattern is wrong."""
    parent = PurePosixPath(path.removeprefix(f"{folder}/")).parent
    moved = "/" in pattern and parent == PurePosixPath()
    wanted = f"{'launch' if moved else parent}/*launch.py"
    name = PurePosixPath(path).name
    return Feedback(
        summary=f"`{name}` is not installed: the pattern `{pattern}` in setup.py does not match it.",
        expected=f"a file in the folder `{wanted.partition('/')[0]}`"
        if moved
        else f"`{wanted}`, which matches",
        seen="the file is next to setup.py" if moved else f"`{pattern}`",
        where=(Location(path), where) if moved else (where,),
        advice=f"Move the file to the folder `launch`, and write `glob('{wanted}')`."
        if moved
        else f"Write `glob('{wanted}')`.",
    )


def _no_such_file(there: list[str], folder: str, file: str) -> Feedback:
    names = {PurePosixPath(name).name: name for name in there}
    close = nearest(file, names)
    wrong = next((name for name in names if not name.endswith(_ENDINGS) and name.endswith(".py")), None)
    found = close or wrong
    return Feedback(
        summary=f"The package has no launch file `{file}`; it has `{found}`."
        if found
        else f"The package has no launch file `{file}`.",
        expected=f"launch/{file}",
        seen=found or listed(sorted(names), "no file in `launch`"),
        where=(Location(names[found]),) if found else (),
        advice="A launch file's name ends in `launch.py`; otherwise `ros2 launch` does not find it."
        if found and not found.endswith(_ENDINGS)
        else f"{'Rename' if found else 'Create'} it: `{folder}/launch/{file}`.",
    )


def _patterns(sources: Sources, setup: str) -> Iterator[tuple[str, Location]]:
    """Strings in setup.py that match launch files: a glob pattern or a file's own name."""
    tree = parsed(sources.files.get(setup, ""))
    for node in ast.walk(tree) if tree else ():
        text = _text(node)
        if text and ("launch" in text) and (text.endswith((".py", "*", ".xml", ".yaml"))) and "=" not in text:
            yield text.removeprefix("./"), Location(setup, getattr(node, "lineno", None))


def _text(node: ast.AST) -> str | None:
    """A string, or the path that `os.path.join('launch', '*.py')` builds."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str) and "/" in node.value:
        return node.value
    if isinstance(node, ast.Call) and called_name(node) == "join":
        parts = [part.value for part in node.args if isinstance(part, ast.Constant)]
        return "/".join(map(str, parts)) if len(parts) == len(node.args) else None
    return None


def launch_file_cause(sources: Sources, packages: BuiltPackages, file: str, error: str = "") -> Cause | None:
    """What is wrong inside a launch file of this name, which `ros2 launch` rejects with `error`."""
    path = next((name for name in sources.files if PurePosixPath(name).name == file), None)
    if path is None:
        return None
    own = Sources({path: sources.files[path]})
    found = no_generate(own) or parameters_as_dict(own) or dict_in_arguments(own)
    return found or not_a_list(own, error) or unknown_keyword(own, error) or misspelt_target(own, packages)


def no_generate(launch_file: Sources) -> Cause | None:
    """A launch file without the function that `ros2 launch` calls."""
    for path, text in launch_file.files.items():
        tree = parsed(text)
        if tree is None:
            return None
        defined = {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef)}
        if "generate_launch_description" in defined:
            return _returns_nothing(path, defined["generate_launch_description"])
        close = nearest("generate_launch_description", defined)
        return Cause(
            "`ros2 launch` calls the function `generate_launch_description`, but the file "
            + (f"has `{close}` instead." if close else "does not define it."),
            (Location(path, defined[close].lineno if close else None),),
        )
    return None


def _returns_nothing(path: str, function: ast.FunctionDef) -> Cause | None:
    if function.args.args and not function.args.defaults:
        text = f"`ros2 launch` calls `{function.name}` with no arguments: write `def {function.name}():`."
        return Cause(text, (Location(path, function.lineno),))
    if any(isinstance(node, ast.Return) and node.value for node in ast.walk(function)):
        return None
    return Cause(
        "`generate_launch_description` returns nothing: end it with `return LaunchDescription([...])`.",
        (Location(path, function.lineno),),
    )


def parameters_as_dict(launch_file: Sources) -> Cause | None:
    """`parameters={...}` where a list of dicts belongs."""
    for node in calls(launch_file, "Node"):
        given = node.keywords.get("parameters")
        if isinstance(given, ast.Dict):
            return Cause(
                "`parameters` takes a list of dicts. Put square brackets around the braces: "
                "`parameters=[{...}]`.",
                (Location(node.where.file, given.lineno),),
            )
        for part in ast.walk(given) if given else ():
            if isinstance(part, ast.Set):
                text = "Braces without a `:` make a set. Put a colon between each name and its value."
                return Cause(text, (Location(node.where.file, part.lineno),))
    return None


def dict_in_arguments(launch_file: Sources) -> Cause | None:
    """`arguments=[{'period': 0.25}]`."""
    for node in calls(launch_file, "Node"):
        given = node.keywords.get("arguments")
        for part in ast.walk(given) if given else ():
            if isinstance(part, ast.Dict):
                text = "Parameters belong in `parameters=[{...}]`. `arguments` are words of the command line."
                return Cause(text, (Location(node.where.file, given.lineno if given else None),))
    return None


def not_a_list(launch_file: Sources, error: str) -> Cause | None:
    """`actions=node`, if the error says that something is not iterable."""
    for file, node in nodes(launch_file) if "not iterable" in error else ():
        if isinstance(node, ast.keyword) and node.arg == "actions" and not isinstance(node.value, ast.List):
            text = f"`actions` takes a list, even for one action: `actions=[{ast.unparse(node.value)}]`."
            return Cause(text, (Location(file, node.value.lineno),))
    return None


_KEYWORDS = ("package", "executable", "name", "namespace", "parameters", "remappings", "arguments", "output")


def unknown_keyword(launch_file: Sources, error: str) -> Cause | None:
    """`Node(node_name='talker')`, which the error names."""
    wrong = re.search(r"unexpected keyword argument '(\w+)'", error)
    for call in calls(launch_file, "Node") if wrong else ():
        if wrong and wrong[1] in call.keywords and wrong[1] not in _KEYWORDS:
            right = nearest(wrong[1].removeprefix("node_"), _KEYWORDS, LOOSELY)
            text = f"`Node` has no argument `{wrong[1]}`. " + (
                f"Write `{right}` instead." if right else f"It has {listed(_KEYWORDS)}."
            )
            return Cause(text, (Location(call.where.file, call.keywords[wrong[1]].lineno),))
    return None


def started_twice(launch_file: Sources) -> Cause | None:
    """Two `Node(...)` with the same executable, where a node is missing."""
    seen: dict[str, Location] = {}
    for call in calls(launch_file, "Node"):
        executable = _constant(call, "executable")
        if executable is None:
            continue
        if executable in seen:
            text = f"Two of the nodes start `{executable}`. One of them should start another program."
            return Cause(text, (call.where, seen[executable]))
        seen[executable] = call.where
    return None


def of_another_node(launch_file: Sources, node: str, parameter: str) -> Cause | None:
    """A parameter of `node` that the launch file gives to another `Node(...)`."""
    every = calls(launch_file, "Node")
    own = [
        call for call in every if any(node in (_constant(call, key) or "") for key in ("executable", "name"))
    ]
    for call in every:
        given = [
            part for part in ast.walk(call.keywords.get("parameters", ast.Pass())) if _is(part, parameter)
        ]
        if own and given and call not in own:
            text = f"`{parameter}` belongs to `{node}`, but this `Node(...)` starts something else. Move it."
            return Cause(text, (Location(call.where.file, given[0].lineno),))
    return None


def _is(node: ast.AST, text: str) -> TypeGuard[ast.Constant]:
    return isinstance(node, ast.Constant) and node.value == text


def misspelt_target(launch_file: Sources, packages: BuiltPackages) -> Cause | None:
    """A `Node(...)` whose package or executable was not built; unknown packages may belong to ROS."""
    for node in calls(launch_file, "Node"):
        package, executable = _constant(node, "package"), _constant(node, "executable")
        built = packages.get(package or "")
        close = nearest(package or "", (one.name for one in packages.built))
        if package and built is None and close:
            return Cause(
                f"The launch file names the package `{package}`, but its name is `{close}`.", (node.where,)
            )
        if built and executable and executable not in built.executables:
            close = nearest(executable, built.executables)
            there = f"it has `{close}`" if close else f"it has {listed(built.executables, 'no executable')}"
            return Cause(
                f"The launch file names the executable `{executable}`, which `{package}` does not "
                f"have; {there}.",
                (node.where,),
            )
    return None


def _constant(call: PythonCall, keyword: str) -> str | None:
    node = call.keywords.get(keyword)
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def _line(sources: Sources, file: str, text: str) -> Iterator[Location]:
    for number, line in enumerate(sources.files.get(file, "").splitlines(), start=1):
        if text in line:
            yield Location(file, number)
            return
