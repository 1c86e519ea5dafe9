"""What a function of a grader module uses, followed by name through modules, without running any."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence
from pathlib import Path

import course

_ENGINE = "course.grading."
# Decorators of ours: they name the grader, and with it the points of a check.
_OURS = frozenset({"scenario", "check"})
_DOCUMENTED = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Module)


class Definitions:
    """Collects definitions. texts: their sources in a normal form. strings: all that stand in them.

    folder: of the graders; modules in it are followed, and those of `course.grading`. Others are named only.
    """

    def __init__(self, folder: Path) -> None:
        self.texts: set[str] = set()
        self.strings: set[str] = set()
        self._folder = folder
        self._modules: dict[Path, dict[str, list[ast.stmt]]] = {}
        self._seen: set[tuple[Path, str]] = set()

    def follow(self, file: Path, name: str) -> None:
        """Take what the module `file` calls `name`, and all that this uses."""
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
        """The statements at the top of a module by the names that they bind."""
        if file not in self._modules:
            found: dict[str, list[ast.stmt]] = {}
            for node in _statements(normal(parsed(file)).body):
                for name in _bound(node):
                    found.setdefault(name, []).append(node)
            self._modules[file] = found
        return self._modules[file]

    def _file(self, module: str) -> Path | None:
        """The file of a module that is followed."""
        root = Path(course.__file__).parents[1] if module.startswith(_ENGINE) else self._folder
        place = root.joinpath(*module.split("."))
        candidates = (place.with_suffix(".py"), place / "__init__.py")
        return next((file for file in candidates if module and file.is_file()), None)


def parsed(file: Path) -> ast.Module:
    return ast.parse(file.read_text(encoding="utf-8"), str(file))


def normal(tree: ast.Module) -> ast.Module:
    """The same (not a copy) without docstrings, and without the decorators of scenarios and checks."""
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
    """All that are run when the module is, those inside `if` and the like too."""
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
