"""Whether a Python package's build does nothing with its modules but copy them.

setup.py is a program and may do anything; nearly all say only what `ros2 pkg create` wrote and what ROS's
tutorials add to it. These are known here by what they consist of. Whatever else there is counts as not plain.
"""

from __future__ import annotations

import ast
import configparser
import importlib.util
from collections.abc import Iterable
from pathlib import Path, PurePosixPath

_IMPORTS = {
    None: {"os", "os.path", "glob", "setuptools"},
    "setuptools": {"setup", "find_packages"},
    "glob": {"glob"},
    "os": {"path"},
    "os.path": {"join"},
}
# They look at names of files alone.
_CALLS = frozenset(
    {"find_packages", "setuptools.find_packages", "glob", "glob.glob", "os.path.join", "path.join", "join"}
)
_SETUP = frozenset({"setup", "setuptools.setup"})
_SAYS = frozenset(
    "name version packages data_files install_requires extras_require tests_require zip_safe entry_points "
    "author author_email maintainer maintainer_email keywords classifiers url description long_description "
    "license python_requires".split()
)
_VALUES = (
    ast.Constant,
    ast.List,
    ast.Tuple,
    ast.Dict,
    ast.JoinedStr,
    ast.FormattedValue,
    ast.BinOp,
    ast.Add,
    ast.Name,
    ast.Load,
    ast.keyword,
)
_OTHER_SETTINGS = frozenset({"pyproject.toml", "MANIFEST.in"})
_CONFIGURED = {"develop": {"script_dir", "script-dir"}, "install": {"install_scripts", "install-scripts"}}


def is_plain(folder: Path, names: Iterable[str]) -> bool:
    """names: of all files in the package's folder, relative to it."""
    names = frozenset(names)
    return (
        "setup.py" in names
        and not names & _OTHER_SETTINGS
        and not any(_may_be_imported(PurePosixPath(name)) for name in names)
        and _is_plain_setup(folder / "setup.py")
        and ("setup.cfg" not in names or _is_plain_config(folder / "setup.cfg"))
    )


def _may_be_imported(name: PurePosixPath) -> bool:
    """Whether setuptools could come upon it: setup.py runs with the package's folder first in its path."""
    top = name.parts[0]
    if len(name.parts) == 1:
        return name.suffix == ".py" and top != "setup.py"
    # Of folders it takes those with an __init__.py first, others only when there is nothing else.
    return name.parts[1:] == ("__init__.py",) and (not top.isidentifier() or _is_known(top))


def _is_known(module: str) -> bool:
    if module == "test":  # Python's own is none that setuptools asks for
        return False
    try:
        return importlib.util.find_spec(module) is not None
    except ValueError:  # it is one of the running program's
        return True


def _is_plain_setup(file: Path) -> bool:
    try:
        module = ast.parse(file.read_bytes())
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return False
    return all(_is_plain_statement(statement) for statement in module.body)


def _is_plain_statement(statement: ast.stmt) -> bool:
    match statement:
        case ast.Import(names=names):
            return _are_known(None, names)
        case ast.ImportFrom(module=str(module), names=names, level=0):
            return _are_known(module, names)
        case ast.Assign(targets=[ast.Name()], value=value):
            return _is_value(value)
        case ast.Expr(value=ast.Constant()):
            return True
        case ast.Expr(value=ast.Call(func=function, args=[], keywords=said)):
            return ast.unparse(function) in _SETUP and all(
                one.arg in _SAYS and _is_value(one.value) for one in said
            )
    return False


def _are_known(module: str | None, names: Iterable[ast.alias]) -> bool:
    known = _IMPORTS.get(module, set())
    return all(name.asname is None and name.name in known for name in names)


def _is_value(value: ast.expr) -> bool:
    waiting: list[ast.AST] = [value]
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.Call):
            if ast.unparse(node.func) not in _CALLS:
                return False
            waiting += [*node.args, *node.keywords]
        elif isinstance(node, _VALUES):
            waiting += ast.iter_child_nodes(node)
        else:
            return False
    return True


def _is_plain_config(file: Path) -> bool:
    config = configparser.RawConfigParser()
    try:
        config.read_string(file.read_text(encoding="utf-8"))
    except (configparser.Error, ValueError):
        return False
    return not config.defaults() and all(
        section in _CONFIGURED and set(config.options(section)) <= _CONFIGURED[section]
        for section in config.sections()
    )
