"""The text of a grader module: which of its functions judge an exercise, and the numbers it names."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

Defined = ast.FunctionDef | ast.ClassDef


@dataclass(frozen=True)
class Judging:
    """A function (or class) that takes part in judging. checks: ids of the checks that use it, in order."""

    node: Defined
    checks: tuple[str, ...]
    is_check: bool


class Source:
    """A parsed grader module. Raises OSError, SyntaxError, or ValueError if it cannot be parsed."""

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
        """The exercise's checks, and what they use of this module, in the order of the file."""
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
    """The names in `name = Grader("exercise")`."""
    for node in tree.body:
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Call) and node.value.args:
            first = node.value.args[0]
            of_it = isinstance(first, ast.Constant) and first.value == exercise
            if of_it and ast.unparse(node.value.func).endswith("Grader"):
                yield ast.unparse(node.targets[0])


def _check_of(decorator: ast.expr, graders: set[str]) -> str | None:
    """The id in `@name.check("id", ...)`."""
    if not isinstance(decorator, ast.Call) or not isinstance(decorator.func, ast.Attribute):
        return None
    if decorator.func.attr != "check" or ast.unparse(decorator.func.value) not in graders:
        return None
    given = [*decorator.args[:1], *(one.value for one in decorator.keywords if one.arg == "id")]
    return next((str(one.value) for one in given if isinstance(one, ast.Constant)), None)


_MADE = frozenset({"Feedback", "Location"})
_TEXTS = frozenset({"advice", "remedy", "summary", "what", "near_miss", "details", "where"})


def words(functions: Sequence[Defined]) -> set[ast.AST]:
    """All nodes of these functions that only make texts."""
    found: set[ast.AST] = set()
    for node in _every(functions):
        found.update(_plainly(node))
    before = -1
    while before != len(found):  # code that is used only for texts is also found
        before = len(found)
        for function in functions:
            found.update(_of_variables(function, found))
            found.update(_of_choices(function, found))
        found.update(_of_functions(functions, found))
    return found


def _every(nodes: Iterable[ast.AST]) -> Iterator[ast.AST]:
    for node in nodes:
        yield from ast.walk(node)


def _plainly(node: ast.AST) -> Iterator[ast.AST]:
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in _MADE:
        yield from ast.walk(node)
    elif isinstance(node, ast.keyword) and node.arg in _TEXTS:
        yield from ast.walk(node.value)
    elif isinstance(node, ast.FunctionDef) and node.returns is not None:
        if ast.unparse(node.returns) == "Feedback":
            yield from _every(node.body)
    elif isinstance(node, ast.Raise) and node.exc is not None:
        yield from ast.walk(node.exc)
    elif isinstance(node, ast.If) and not node.orelse and all(_is_ours(part) for part in node.body):
        yield from ast.walk(node)


def _is_ours(node: ast.stmt) -> bool:
    """Whether it raises something that does not judge the learner's work."""
    return isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call) and not _judges(node.exc)


def _judges(node: ast.Call) -> bool:
    return ast.unparse(node.func) in ("Failure", "NotApplicable")


def _of_variables(function: Defined, known: set[ast.AST]) -> Iterator[ast.AST]:
    real = {
        node.id
        for node in ast.walk(function)
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load) and node not in known
    }
    for node in ast.walk(function):
        if isinstance(node, ast.Assign):
            names = [one for target in node.targets for one in ast.walk(target)]
            plain = all(isinstance(one, ast.Name | ast.Tuple | ast.expr_context) for one in names)
            if plain and not any(isinstance(one, ast.Name) and one.id in real for one in names):
                yield from ast.walk(node)


def _of_choices(function: Defined, known: set[ast.AST]) -> Iterator[ast.AST]:
    """An `if` that only chooses between texts."""
    for node in ast.walk(function):
        if isinstance(node, ast.If) and all(part in known for part in (*node.body, *node.orelse)):
            yield from ast.walk(node)


def _of_functions(functions: Sequence[Defined], known: set[ast.AST]) -> Iterator[ast.AST]:
    names = {function.name: function for function in functions if not function.decorator_list}
    real = {
        node.id
        for function in functions
        for node in ast.walk(function)
        if isinstance(node, ast.Name) and node not in known and node.id != function.name
    }
    for name, function in names.items():
        if name not in real:
            yield from _every(function.body)
