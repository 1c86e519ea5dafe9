"""The text of a grader module: which of its functions judge an exercise, and the numbers it names."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

Defined = ast.FunctionDef | ast.ClassDef


@dataclass(frozen=True)
class Judging:
    """A function (or class) that takes part in judging. checks: ids of those that use it, in their order."""

    node: Defined
    checks: tuple[str, ...]
    is_check: bool


class Source:
    """A grader module, parsed. Raises OSError, SyntaxError and ValueError for what is none."""

    def __init__(self, file: Path) -> None:
        self.file = file
        self.text = file.read_bytes()
        self.tree = ast.parse(self.text, str(file))
        self.defined = {node.name: node for node in self.tree.body if isinstance(node, Defined)}
        self._starts = [0]
        for line in self.text.splitlines(keepends=True):
            self._starts.append(self._starts[-1] + len(line))

    @cached_property
    def numbers(self) -> dict[str, int | float]:
        """Constants of the module, by name."""
        found: dict[str, int | float] = {}
        for node in self.tree.body:
            if isinstance(node, ast.Assign) and isinstance(node.value, ast.Constant):
                value, target = node.value.value, node.targets[0]
                if isinstance(target, ast.Name) and isinstance(value, int | float):
                    found[target.id] = value
        return found

    def judging(self, exercise: str) -> tuple[Judging, ...]:
        """Those of the exercise's checks, and what they use of this module; in the order of the file."""
        used: dict[str, list[str]] = {}
        own = dict(self._checks(exercise))
        for check, name in own.items():
            for reached in self._reached(name):
                used.setdefault(reached, []).append(check)
        found = [Judging(self.defined[name], tuple(by), name in own.values()) for name, by in used.items()]
        return tuple(sorted(found, key=lambda one: one.node.lineno))

    def _checks(self, exercise: str) -> Iterator[tuple[str, str]]:
        """The id and the function's name of each check of the exercise."""
        graders = set(_graders(self.tree, exercise))
        for name, node in self.defined.items():
            for decorator in node.decorator_list:
                check = _check_of(decorator, graders)
                if check is not None:
                    yield check, name

    def _reached(self, name: str) -> set[str]:
        found, waiting = {name}, [name]
        while waiting:
            for used in ast.walk(self.defined[waiting.pop()]):
                if isinstance(used, ast.Name) and used.id in self.defined and used.id not in found:
                    found.add(used.id)
                    waiting.append(used.id)
        return found

    def start(self, node: ast.expr | ast.stmt) -> int:
        return self._starts[node.lineno - 1] + node.col_offset

    def end(self, node: ast.expr | ast.stmt) -> int:
        assert node.end_lineno is not None and node.end_col_offset is not None
        return self._starts[node.end_lineno - 1] + node.end_col_offset

    def line_of(self, place: int) -> int:
        return self.text.count(b"\n", 0, place) + 1


def _graders(tree: ast.Module, exercise: str) -> Iterator[str]:
    """Of `name = Grader("exercise")`: the name."""
    for node in tree.body:
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Call) and node.value.args:
            first = node.value.args[0]
            of_it = isinstance(first, ast.Constant) and first.value == exercise
            if of_it and ast.unparse(node.value.func).endswith("Grader"):
                yield ast.unparse(node.targets[0])


def _check_of(decorator: ast.expr, graders: set[str]) -> str | None:
    """Of `@name.check("id", ...)`: the id."""
    if not isinstance(decorator, ast.Call) or not isinstance(decorator.func, ast.Attribute):
        return None
    if decorator.func.attr != "check" or ast.unparse(decorator.func.value) not in graders:
        return None
    given = [*decorator.args[:1], *(one.value for one in decorator.keywords if one.arg == "id")]
    return next((str(one.value) for one in given if isinstance(one, ast.Constant)), None)
