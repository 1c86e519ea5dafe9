"""The checks that a grader module declares, read without running it.

Loading a module stops at its first wrong check; this sees all of them, and knows their lines.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from course.grading.author import BUILDS


@dataclass(frozen=True)
class Check:
    """One `@grader.check(...)`. needs: None where it is not written out; then it is not judged."""

    id: str
    line: int
    needs: tuple[str, ...] | None
    can_fail: bool = True


@dataclass
class Declaration:
    """One `Grader("18-publisher")`. whole: whether all its checks are written out, so that this is all."""

    exercise: str
    line: int
    builds: bool
    checks: list[Check] = field(default_factory=list)
    whole: bool = True

    def line_of(self, check: str) -> int:
        return next((one.line for one in self.checks if one.id == check), self.line)


def declarations(tree: ast.Module) -> tuple[Declaration, ...]:
    """The graders of a module, with their checks in order."""
    texts = dict(_texts(tree))
    found = dict(_graders(tree, texts))
    functions = {id(call): node for node in ast.walk(tree) for call in _decorators(node)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "check":
            owner = node.func.value
            if isinstance(owner, ast.Name) and owner.id in found:
                _add(found[owner.id], node, texts, functions.get(id(node)))
    for declaration in found.values():
        declaration.checks.sort(key=lambda check: check.line)
    return tuple(found.values())


def _texts(tree: ast.Module) -> Iterator[tuple[str, str]]:
    """Constants of the module: `NAME = "text"`."""
    yield "BUILDS", BUILDS
    for node in tree.body:
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Constant):
            for target in node.targets:
                if isinstance(target, ast.Name) and isinstance(node.value.value, str):
                    yield target.id, node.value.value


def _graders(tree: ast.Module, texts: Mapping[str, str]) -> Iterator[tuple[str, Declaration]]:
    for node in tree.body:
        if isinstance(node, ast.Assign) and _is_grader(node.value) and isinstance(node.targets[0], ast.Name):
            assert isinstance(node.value, ast.Call)
            exercise = _text(node.value.args[0], texts) if node.value.args else None
            if exercise is not None:
                builds = _keyword(node.value, "builds")
                without = isinstance(builds, ast.Constant) and builds.value is None
                yield node.targets[0].id, Declaration(exercise, node.lineno, not without)


def _is_grader(value: ast.expr) -> bool:
    return isinstance(value, ast.Call) and isinstance(value.func, ast.Name) and value.func.id == "Grader"


def _decorators(node: ast.AST) -> list[ast.expr]:
    return node.decorator_list if isinstance(node, ast.FunctionDef) else []


def _add(owner: Declaration, call: ast.Call, texts: Mapping[str, str], function: ast.AST | None) -> None:
    given = call.args[0] if call.args else _keyword(call, "id")
    name = _text(given, texts) if given is not None else None
    if name is None:
        owner.whole = False
        return
    needs = _needs(_keyword(call, "needs"), texts, (BUILDS,) if owner.builds else ())
    owner.checks.append(Check(name, call.lineno, needs, function is None or _can_fail(function)))


def _needs(
    value: ast.expr | None, texts: Mapping[str, str], default: tuple[str, ...]
) -> tuple[str, ...] | None:
    if value is None or (isinstance(value, ast.Constant) and value.value is None):
        return default
    items = value.elts if isinstance(value, ast.Tuple | ast.List) else [value]
    names = [_text(item, texts) for item in items]
    known = tuple(name for name in names if name is not None)
    return known if len(known) == len(names) else None


def _can_fail(function: ast.AST) -> bool:
    """False for one that raises NotApplicable alone, and calls no function that might raise others."""
    nodes = [node for body in getattr(function, "body", []) for node in ast.walk(body)]
    raised = [node.exc for node in nodes if isinstance(node, ast.Raise)]
    called = [node.func for node in nodes if isinstance(node, ast.Call)]
    functions = {node.id for node in called if isinstance(node, ast.Name)}
    return not raised or functions != {"NotApplicable"} or not all(isinstance(e, ast.Call) for e in raised)


def _keyword(call: ast.Call, name: str) -> ast.expr | None:
    return next((one.value for one in call.keywords if one.arg == name), None)


def _text(node: ast.expr, texts: Mapping[str, str]) -> str | None:
    if isinstance(node, ast.Name):
        return texts.get(node.id)
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def parsed(file: Path) -> ast.Module | None:
    """The module's tree; None when it has none, which loading it tells."""
    try:
        return ast.parse(file.read_bytes(), str(file))
    except (OSError, SyntaxError, ValueError, RecursionError):
        return None
