"""What grader modules must not do: write files, start programs, and import internals of the engine.

A grader runs with all rights, next to a submission that can replace any file with a link. So it leaves
writing to the arena, which uses only the submission's own rights. These rules judge code by its names alone.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

from course.content import layout
from course.validate import Finding
from course.validate.static.graders import parsed
from course.validate.static.subject import Subject, files_in

# Programs for the sandbox, which run with the submission's rights.
PROBES = "probes"
_OF_PATHS = frozenset(
    """write_text write_bytes mkdir rmdir unlink rename symlink_to hardlink_to touch chmod lchmod rmtree
    copytree copyfile makedirs removedirs truncate mkfifo mknod extractall""".split()
)
# Functions of `os`.
_OF_OS = frozenset(
    """chmod chown lchown link makedirs mkdir mkfifo mknod open remove removedirs rename renames replace rmdir
    symlink truncate unlink utime""".split()
)
_READING = frozenset({"shutil.which", "shutil.get_terminal_size", "shutil.disk_usage"})
_STARTING = re.compile(
    r"subprocess\.(run|call|check_|get|Popen)|os\.(exec|spawn|posix_spawn|system|popen|fork)"
    r"|(pty|pexpect)\.(spawn|fork|run)|.*\.create_subprocess_"
)
_ARCHIVES = frozenset({"zipfile", "tarfile"})
# Here, the mode is the second argument; for a path's own `open`, it is the first.
_OPENING = frozenset(
    """open io.open io.FileIO codecs.open pathlib.Path.open gzip.open gzip.GzipFile bz2.open bz2.BZ2File
    lzma.open lzma.LZMAFile tarfile.open tarfile.TarFile tarfile.TarFile.open zipfile.ZipFile""".split()
)
_WRITING_MODES = frozenset("wax+")
_WRITES = "writes a file, where a submission may have put a link"
_STARTS = "starts a program with all permissions, which may write where a submission has put a link"
_ENGINE, _API = "course", "course.api"
_STEP = (
    "`arena.fresh({path: text})` puts files into a new home, `arena.handed(file)` gives programs a file of "
    "the course, `arena.tool('rm', ...)` does the rest with the submission's own permissions"
)


def code_findings(subject: Subject) -> Iterator[Finding]:
    """Findings in the chapters' grader modules, and in modules that these share."""
    for folder in {layout.grader_file(chapter).parent for chapter in subject.chapters}:
        for file in files_in(folder) if folder.is_dir() else ():
            if file.suffix == ".py" and PROBES not in file.relative_to(folder).parts:
                tree = parsed(file)
                if tree is not None:
                    yield from (*_acting(file, tree), *_importing(file, tree))


def _importing(file: Path, tree: ast.Module) -> Iterator[Finding]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Import | ast.ImportFrom):
            for name in dict.fromkeys(_modules(node)):
                if name.split(".")[0] == _ENGINE and name != _API:
                    what = f"imports `{name}`, which is not meant for graders and may change"
                    yield Finding(file, node.lineno, what, f"import what you need from `{_API}`")


def _modules(node: ast.Import | ast.ImportFrom) -> Iterator[str]:
    """The imported modules: `course.grading` for `from course import grading`."""
    if isinstance(node, ast.Import) or node.module == _ENGINE:
        start = f"{_ENGINE}." if isinstance(node, ast.ImportFrom) else ""
        yield from (f"{start}{alias.name}" for alias in node.names)
    else:
        yield node.module or ""


def _acting(file: Path, tree: ast.Module) -> Iterator[Finding]:
    """Findings for functions that are called, or passed on, as in `map(os.unlink, files)`."""
    imported = dict(_imported(tree))
    for call in (node for node in ast.walk(tree) if isinstance(node, ast.Call)):
        for function in (call.func, *call.args):
            name = _full_name(function, imported)
            writes = _writes(name) or (function is call.func and _call_writes(call, name, imported))
            what = _STARTS if _STARTING.match(name) else _WRITES if writes else None
            if what:
                yield Finding(file, call.lineno, f"`{ast.unparse(function)}` {what}", _STEP)


def _imported(tree: ast.Module) -> Iterator[tuple[str, str]]:
    """Names in the module, with their full names: `rmtree` is `shutil.rmtree`."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from ((alias.asname or alias.name, alias.name) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield from ((alias.asname or alias.name, f"{node.module}.{alias.name}") for alias in node.names)


def _writes(name: str) -> bool:
    module, _, function = name.rpartition(".")
    if module == "pathlib.Path":
        return function in _OF_PATHS or function == "replace"
    return function in _OF_OS if module == "os" else module in ("shutil", "tempfile") and name not in _READING


def _call_writes(call: ast.Call, name: str, imported: dict[str, str]) -> bool:
    function = name.rpartition(".")[2]
    if name in _OPENING or function == "open":
        return _opens_for_writing(call, at=1 if name in _OPENING else 0)
    if function == "extract":  # other objects have a method of this name, too
        return any(origin.partition(".")[0] in _ARCHIVES for origin in imported.values())
    # A string has a method `replace`, too, with two arguments.
    one = len(call.args) == 1 and not call.keywords
    return isinstance(call.func, ast.Attribute) and (function in _OF_PATHS or (function == "replace" and one))


def _full_name(function: ast.expr, imported: dict[str, str]) -> str:
    """`shutil.rmtree`, however it was imported. For other expressions, `?` and the last attribute."""
    if isinstance(function, ast.Name):
        return imported.get(function.id, function.id)
    if isinstance(function, ast.Attribute):
        owner = function.value
        return f"{imported.get(owner.id, owner.id) if isinstance(owner, ast.Name) else '?'}.{function.attr}"
    return "?"


def _opens_for_writing(call: ast.Call, at: int) -> bool:
    """at: the position of the mode among the arguments."""
    given = [keyword.value for keyword in call.keywords if keyword.arg == "mode"] or call.args[at : at + 1]
    known = [mode.value if isinstance(mode, ast.Constant) else "w" for mode in given]
    return any(_WRITING_MODES & set(re.split("[:|]", str(mode))[0]) for mode in known)  # not for `r:xz`
