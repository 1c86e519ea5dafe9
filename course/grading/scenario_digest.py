"""A digest of what made a recording, to tell whether the current scenario would record the same evidence.

It covers the source of the scenario's function and of everything that it uses: helpers, constants, and files
below the graders' folder that it names (probes). Names are followed through its module, the modules next to
it, and `course.grading`. It also covers the mystery's module, and which files of the course home are kept.
Comments, docstrings, formatting and order do not count. Neither do the checks, their titles and points, which
may change while the evidence stays the same. Nor does what the arena itself records: a recording that can no
longer be read has a different format (`mcap_file.OtherFormat`).
"""

from __future__ import annotations

import ast
import contextlib
import hashlib
from collections.abc import Iterator, Sequence
from pathlib import Path

import course
from course.errors import OurFault
from course.grading.mystery import Mystery

# The argument of `Grader(...)` that does not affect what is recorded.
_POINTS = "builds"


def scenario_digest(grader: Path, exercise: str, looks_at: Sequence[str]) -> str:
    """Digest of what determines the evidence for this exercise; empty if a module cannot be read.

    grader: its module. looks_at: files, folders and patterns of the course home that become evidence.
    """
    try:
        parts = [*_scenario(grader, exercise), *_mystery(grader, exercise), *sorted(looks_at)]
    except (OSError, SyntaxError, ValueError, RecursionError):
        return ""
    return hashlib.sha256("\n\0".join(parts).encode()).hexdigest()


def _scenario(grader: Path, exercise: str) -> Iterator[str]:
    tree = parsed(grader)
    declared = _declaration(tree, exercise)
    if declared is None:  # it is declared in some other way: anything here may matter
        yield ast.unparse(normal(tree))
        return
    name, arguments = declared
    yield from arguments
    used = Definitions(grader.parent)
    for function in _scenarios(tree, name):
        used.follow(grader, function)
    yield from sorted(used.texts)
    yield from _files_named(grader.parent, used.strings)


def _declaration(tree: ast.Module, exercise: str) -> tuple[str, list[str]] | None:
    """In `name = Grader("exercise", ros=False)`: the name, and the arguments that matter."""
    for node in tree.body:
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Call) and node.value.args:
            call, target, first = node.value, node.targets[0], node.value.args[0]
            if ast.unparse(call.func).endswith("Grader") and ast.unparse(first) == repr(exercise):
                kept = [ast.unparse(one) for one in call.keywords if one.arg != _POINTS]
                return ast.unparse(target), sorted(kept)
    return None


def _scenarios(tree: ast.Module, grader: str) -> Iterator[str]:
    """The names of functions that are decorated with `scenario` or passed to it."""
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef) and any(_decorates(one, grader) for one in node.decorator_list):
            yield node.name
        elif isinstance(node, ast.Call) and _decorates(node.func, grader):
            yield from (one.id for one in ast.walk(node) if isinstance(one, ast.Name))


def _decorates(node: ast.expr, grader: str) -> bool:
    return isinstance(node, ast.Attribute) and node.attr == "scenario" and ast.unparse(node.value) == grader


def _mystery(grader: Path, exercise: str) -> Iterator[str]:
    with contextlib.suppress(OurFault):  # there is none
        yield ast.unparse(normal(parsed(Mystery(exercise, str(grader)).file)))


def _files_named(folder: Path, strings: set[str]) -> Iterator[str]:
    """Texts of files in the graders' folder that the scenario names."""
    for file in sorted(folder.glob("*/*")):
        if file.name in strings and file.is_file():
            yield file.read_text(encoding="utf-8", errors="replace")


# The engine's modules into which names are followed: scenarios' helpers, and the module that exports them.
_ENGINE = ("course.api", "course.grading.")
# Our decorators, which are left out: they name the grader, and contain the points of a check.
_OURS = frozenset({"scenario", "check"})
_DOCUMENTED = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Module)


class Definitions:
    """Collects definitions. texts: their sources in a normal form. strings: all string constants in them.

    folder: of the graders. Names are followed into its modules and those of `course.grading`, also through
    `course.api`. Of definitions in other modules, only the name is collected.
    """

    def __init__(self, folder: Path) -> None:
        self.texts: set[str] = set()
        self.strings: set[str] = set()
        self._folder = folder
        self._modules: dict[Path, dict[str, list[ast.stmt]]] = {}
        self._seen: set[tuple[Path, str]] = set()

    def follow(self, file: Path, name: str) -> None:
        """Take what the module `file` calls `name`, and everything that it uses."""
        if (file, name) in self._seen:
            return
        self._seen.add((file, name))
        for node in self._module(file).get(name, ()):
            if isinstance(node, ast.Import | ast.ImportFrom):
                self._import(node, name)
            else:
                self._take(file, node)

    def _take(self, file: Path, node: ast.stmt) -> None:
        self.texts.add(ast.unparse(node))
        for one in ast.walk(node):
            if isinstance(one, ast.Name):
                self.follow(file, one.id)
            elif isinstance(one, ast.Constant) and isinstance(one.value, str):
                self.strings.add(one.value)

    def _import(self, node: ast.Import | ast.ImportFrom, name: str) -> None:
        alias = next(one for one in node.names if _bound_by(one) == name)
        package = (node.module or "") if isinstance(node, ast.ImportFrom) else ""
        whole = self._file(f"{package}.{alias.name}" if package else alias.name)
        file = self._file(package)
        if whole:
            self.texts.add(ast.unparse(normal(parsed(whole))))
        elif file and alias.name in self._module(file):
            self.follow(file, alias.name)
        else:
            self.texts.add(f"{package}.{alias.name}")

    def _module(self, file: Path) -> dict[str, list[ast.stmt]]:
        if file not in self._modules:
            found: dict[str, list[ast.stmt]] = {}
            for node in _statements(normal(parsed(file)).body):
                for name in _bound(node):
                    found.setdefault(name, []).append(node)
            self._modules[file] = found
        return self._modules[file]

    def _file(self, module: str) -> Path | None:
        root = Path(course.__file__).parents[1] if module.startswith(_ENGINE) else self._folder
        place = root.joinpath(*module.split("."))
        candidates = (place.with_suffix(".py"), place / "__init__.py")
        return next((file for file in candidates if module and file.is_file()), None)


def parsed(file: Path) -> ast.Module:
    return ast.parse(file.read_text(encoding="utf-8"), str(file))


def normal(tree: ast.Module) -> ast.Module:
    """The same tree (not a copy) without docstrings and the decorators of scenarios and checks."""
    for node in ast.walk(tree):
        if isinstance(node, _DOCUMENTED) and ast.get_docstring(node, clean=False) is not None:
            node.body = node.body[1:] or [ast.Pass()]
        if isinstance(node, ast.FunctionDef):
            node.decorator_list = [one for one in node.decorator_list if not _is_ours(one)]
    return tree


def _is_ours(decorator: ast.expr) -> bool:
    called = decorator.func if isinstance(decorator, ast.Call) else decorator
    return isinstance(called, ast.Attribute) and called.attr in _OURS


def _statements(body: Sequence[ast.stmt]) -> Iterator[ast.stmt]:
    """All statements that run on import, including those inside `if` and the like."""
    for node in body:
        if isinstance(node, ast.If | ast.Try | ast.With | ast.For | ast.While):
            for part in ("body", "orelse", "finalbody"):
                yield from _statements(getattr(node, part, ()))
            for handler in getattr(node, "handlers", ()):
                yield from _statements(handler.body)
        else:
            yield node


def _bound(node: ast.stmt) -> set[str]:
    if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
        return {node.name}
    if isinstance(node, ast.Import | ast.ImportFrom):
        return {_bound_by(alias) for alias in node.names}
    stored = (one for one in ast.walk(node) if isinstance(one, ast.Name) and isinstance(one.ctx, ast.Store))
    return {one.id for one in stored}


def _bound_by(alias: ast.alias) -> str:
    return alias.asname or alias.name.partition(".")[0]
