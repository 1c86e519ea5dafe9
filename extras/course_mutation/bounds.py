"""Widens the limits of a judgment: tolerances, least and greatest amounts, numbers in comparisons."""

from __future__ import annotations

import ast
import importlib
import inspect
from collections.abc import Iterator

from course.evidence.topic_view import TopicView
from course_mutation.model import Change, Operator
from course_mutation.source import Source

# Arguments that make the judgment milder if they are higher, or lower.
_MOST = frozenset({"tolerance", "within", "at_most", "most", "rel", "abs", "rel_tol", "abs_tol"})
_LEAST = frozenset({"at_least", "least"})
_ORDERS = (ast.Lt, ast.LtE, ast.Gt, ast.GtE)
_ENGINE = "course."
# Smaller numbers only allow for rounding errors; no mistake comes that close.
_ROUNDING = 1e-3


def of_comparison(source: Source, node: ast.Compare) -> Iterator[Change]:
    """Numbers in `<` and similar, doubled and halved, because the code does not say which is milder."""
    if not any(isinstance(operator, _ORDERS) for operator in node.ops):
        return
    for operand in (node.left, *node.comparators):
        for number in _numbers(source, operand):
            for factor in (2.0, 0.5):
                change = _scaled(source, number, factor)
                if change:
                    yield change


def of_call(source: Source, node: ast.Call) -> Iterator[Change]:
    """Tolerances and amounts that a helper gets, or has by default."""
    for argument in node.keywords:
        if argument.arg in _MOST | _LEAST:
            for number in _numbers(source, argument.value):
                change = _scaled(source, number, 2.0 if argument.arg in _MOST else 0.5)
                if change:
                    yield change
    given = {argument.arg for argument in node.keywords}
    for name, value in _defaults(source, node).items():
        if name not in given and None not in given and (node.args or node.keywords):
            last = max(source.end(one) for one in (*node.args, *(one.value for one in node.keywords)))
            wider = value * (2.0 if name in _MOST else 0.5)
            yield Change(Operator.BOUND, last, last, f", {name}={wider:g}".encode(), (value, wider))


def is_whole(source: Source, node: ast.expr) -> bool:
    """Whether it is a whole number, so that one more or less makes a difference."""
    if isinstance(node, ast.Constant):
        return type(node.value) is int
    if isinstance(node, ast.Name):
        return type(source.numbers.get(node.id)) is int
    return isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "len"


def _numbers(source: Source, node: ast.expr) -> Iterator[ast.Constant | ast.Name]:
    """The node itself, or the parts of its calculation, if they are known numbers."""
    if isinstance(node, ast.BinOp):
        yield from _numbers(source, node.left)
        yield from _numbers(source, node.right)
    elif isinstance(node, ast.Constant):
        if type(node.value) in (int, float):
            yield node
    elif isinstance(node, ast.Name) and node.id in source.numbers:
        yield node


def _scaled(source: Source, node: ast.Constant | ast.Name, factor: float) -> Change | None:
    """None for numbers that allow for rounding, and for 0 and 1: see `Operator.BOUNDARY`."""
    value = source.numbers[node.id] if isinstance(node, ast.Name) else node.value
    assert isinstance(value, int | float)
    scaled = value * factor if isinstance(value, float) else int(value * factor)
    if abs(value) < _ROUNDING or value == 1:
        return None
    new = f"{scaled:.12g}".encode()
    return Change(Operator.BOUND, source.start(node), source.end(node), new, (value, scaled))


def _defaults(source: Source, node: ast.Call) -> dict[str, float]:
    """The default limits of an `expect_*` of the engine."""
    name = ast.unparse(node.func).rpartition(".")[2]
    if not name.startswith("expect_"):
        return {}
    function = getattr(TopicView, name, None) if isinstance(node.func, ast.Attribute) else None
    function = function or _imported(source, name)
    if not callable(function):
        return {}
    parameters = inspect.signature(function).parameters.values()
    return {
        one.name: one.default
        for one in parameters
        if one.name in _MOST | _LEAST and type(one.default) in (int, float)
    }


def _imported(source: Source, name: str) -> object:
    """What the module imports from the engine by this name, or None."""
    imports = (node for node in source.tree.body if isinstance(node, ast.ImportFrom))
    for node in imports:
        module = node.module or ""
        if module.startswith(_ENGINE) and any((one.asname or one.name) == name for one in node.names):
            return getattr(importlib.import_module(module), name, None)
    return None
