"""Makes a build from an earlier one of a package that differs only in the contents of its modules.

Nearly every build comes after a line was changed in a module. colcon runs setup.py three times, and the only
result is a copy of that module. Some builds are known to do no more than that (see `is_plain`). For these,
the entry of a similar package is copied, and the changed modules are put in their places.

setup.py is a program and may do anything, but nearly all contain only what `ros2 pkg create` wrote and what
ROS's tutorials add to it. These are recognized by their parts; anything else counts as not plain.
"""

from __future__ import annotations

import ast
import importlib.util
import os
import shutil
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from course.build.cmake_reuse import is_plain_cmake, lay_times, may_differ
from course.build.package_sources import content_key, is_module, likeness_key, source_files
from course.build.runner import Interrupt
from course.build.store import Store, StoreEntry
from course.explain.python_code import parsed
from course.explain.setup_py import read_setup_cfg
from course.files import wipe

_IMPORTS = {
    None: {"os", "os.path", "glob", "setuptools"},
    "setuptools": {"setup", "find_packages"},
    "glob": {"glob"},
    "os": {"path"},
    "os.path": {"join"},
}
# They look only at names of files.
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


def likeness(kept: Path, build_type: str, needed: Iterable[str], identity: str) -> str | None:
    """The key that similar packages share with the one in `kept`; None if its build may do anything.

    needed: keys of the packages that it depends on. identity: identifies the ROS in use.
    """
    files = source_files(kept, kept)
    if any(file.link is not None for file in files):
        return None
    if build_type == "ament_cmake" and is_plain_cmake(files):
        return likeness_key(kept, kept, needed, identity, may_differ)
    if build_type == "ament_python" and is_plain(kept, (file.name for file in files)):
        return likeness_key(kept, kept, needed, identity, is_module)
    return None


def resumed(
    store: Store, like: str, key: str, needed: Iterable[str], identity: str, interrupt: Interrupt
) -> bool:
    """Fill the entry `key` with the build folder and the installation of a similar package, for make."""
    entry, other = store.entry(key), store.alike(like)
    if other is None:
        return False
    earlier, move = store.entry(other), _Move(other.encode(), key.encode())
    try:
        with store.in_use(other, interrupt):
            if not _is_as_built(earlier, other, needed, identity) or not earlier.is_resumable():
                return False
            for old, new in ((earlier.install, entry.install), (earlier.build, entry.build)):
                _copy(old, new, move, {})
            if lay_times(earlier, entry):
                return True
    except OSError:
        pass
    wipe(entry.install, entry.build)
    entry.install.mkdir()
    entry.build.mkdir()
    return False


def _is_as_built(earlier: StoreEntry, key: str, needed: Iterable[str], identity: str) -> bool:
    """Whether the entry is there, and its sources are what it was built from."""
    return earlier.is_complete() and content_key(earlier.src, earlier.src, needed, identity) == key


def reused(store: Store, like: str, key: str, needed: Iterable[str], identity: str) -> bool:
    """Fill the entry `key` from that of a similar package, and return True; or change nothing."""
    entry, other = store.entry(key), store.alike(like)
    earlier = store.entry(other) if other else None
    try:
        if other is None or earlier is None or not _is_as_built(earlier, other, needed, identity):
            return False
        changes = _changes(earlier, entry)
        if changes is None:
            return False
        _copy(earlier.install, entry.install, _Move(other.encode(), key.encode()), changes)
        entry.log.write_bytes(earlier.log.read_bytes().replace(other.encode(), key.encode()))
    except OSError:  # it is being removed, or the disk is full: the build itself will tell
        wipe(entry.install)
        entry.install.mkdir()
        return False
    return True


@dataclass(frozen=True)
class _Move:
    """The keys to replace in files into which a build wrote the path of its entry. They are equally long."""

    old: bytes
    new: bytes


def _changes(earlier: StoreEntry, entry: StoreEntry) -> dict[str, bytes] | None:
    """New contents of installed files by name; None if these files are unknown."""
    before, after = _modules(earlier.src), _modules(entry.kept)
    changed = {name for name in before if before[name] != after[name]}
    suspects = {PurePosixPath(name).name for name in changed}
    changes: dict[str, bytes] = {}
    for file in _files(earlier.install):
        if file.is_symlink():  # nothing that is known here makes one
            return None
        if file.name not in suspects:
            continue
        name = file.relative_to(earlier.install).as_posix()
        sources = _sources(name, file.read_bytes(), before)
        contents = {after[source] for source in sources}
        if len(contents) != 1:
            return None
        changes[name] = contents.pop()
    return changes


def _modules(folder: Path) -> dict[str, bytes]:
    return {file.name: file.path.read_bytes() for file in source_files(folder, folder) if is_module(file)}


def _sources(installed: str, content: bytes, modules: dict[str, bytes]) -> list[str]:
    """Modules that the installed file may be a copy of, judging by the end of its path."""
    base = PurePosixPath(installed).name
    possible = [name for name in modules if modules[name] == content and PurePosixPath(name).name == base]
    exact = [name for name in possible if installed.endswith(f"/{name}")]
    return exact or possible


def _copy(old: Path, new: Path, move: _Move, changes: dict[str, bytes]) -> None:
    compiled = {_compiled(name) for name in changes}
    for folder, _, _ in os.walk(old):
        (new / Path(folder).relative_to(old)).mkdir(exist_ok=True)
    for file in _files(old):
        name = file.relative_to(old).as_posix()
        if _without_tag(name) in compiled:
            continue  # Python compiles the module when it is imported
        target = new / name
        if name in changes:
            target.write_bytes(changes[name])
            shutil.copymode(file, target)
        else:
            target.write_bytes(file.read_bytes().replace(move.old, move.new))
            shutil.copystat(file, target)  # Python checks compiled code by its module's age


def _compiled(module: str) -> str:
    path = PurePosixPath(module)
    return str(path.parent / "__pycache__" / path.stem)


def _without_tag(name: str) -> str:
    """`.../__pycache__/node` of `.../__pycache__/node.cpython-312.pyc`."""
    path = PurePosixPath(name)
    return str(path.parent / path.name.split(".")[0]) if path.suffix == ".pyc" else name


def _files(top: Path) -> Iterable[Path]:
    for folder, _, files in os.walk(top):
        for name in files:
            yield Path(folder, name)


def is_plain(folder: Path, names: Iterable[str]) -> bool:
    """Whether the build only copies modules. names: all files in the folder, relative to it."""
    names = frozenset(names)
    return (
        "setup.py" in names
        and not names & _OTHER_SETTINGS
        and not any(_may_be_imported(PurePosixPath(name)) for name in names)
        and _is_plain_setup(folder / "setup.py")
        and ("setup.cfg" not in names or _is_plain_config(folder / "setup.cfg"))
    )


def _may_be_imported(name: PurePosixPath) -> bool:
    """Whether setuptools could import it: setup.py runs with the package's folder first in its path."""
    top = name.parts[0]
    if len(name.parts) == 1:
        return name.suffix == ".py" and top != "setup.py"
    # It prefers folders with an __init__.py, and takes others only if there is nothing else.
    return name.parts[1:] == ("__init__.py",) and (not top.isidentifier() or _is_known(top))


def _is_known(module: str) -> bool:
    if module == "test":  # setuptools never asks for Python's own
        return False
    try:
        return importlib.util.find_spec(module) is not None
    except ValueError:  # it is one of the running program's
        return True


def _is_plain_setup(file: Path) -> bool:
    try:
        module = parsed(file.read_text(encoding="utf-8"))
    except UnicodeDecodeError:  # it may declare another encoding; colcon reads that
        return False
    return module is not None and all(_is_plain_statement(statement) for statement in module.body)


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
                word.arg in _SAYS and _is_value(word.value) for word in said
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
    try:
        config = read_setup_cfg(file.read_text(encoding="utf-8"))
    except UnicodeDecodeError:
        return False
    return (
        config is not None
        and not config.defaults()
        and all(
            section in _CONFIGURED and set(config.options(section)) <= _CONFIGURED[section]
            for section in config.sections()
        )
    )
