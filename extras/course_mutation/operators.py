"""Ways to weaken a function that judges.

They use the standard library's `ast`, whose nodes know their place in the text. Only the bytes of one node
are replaced, so all lines keep their numbers. (docs/mutation.md says why no library is used.)
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from itertools import pairwise

from course_mutation import bounds
from course_mutation.model import Change, Operator
from course_mutation.source import Judging, Source

_TURNED: dict[type[ast.cmpop], str] = {
    ast.Lt: ">=",
    ast.GtE: "<",
    ast.Gt: "<=",
    ast.LtE: ">",
    ast.Eq: "!=",
    ast.NotEq: "==",
    ast.In: "not in",
    ast.NotIn: "in",
    ast.Is: "is not",
    ast.IsNot: "is",
}
_MOVED: dict[type[ast.cmpop], str] = {ast.Lt: "<=", ast.LtE: "<", ast.Gt: ">=", ast.GtE: ">"}
_COMPARES = re.compile(rb"not\s+in|is\s+not|<=|>=|==|!=|<|>|\bin\b|\bis\b")
_JOINS = {ast.And: (re.compile(rb"\band\b"), b"or"), ast.Or: (re.compile(rb"\bor\b"), b"and")}
_NEWLINE = b"\n"


def changes(source: Source, judging: Judging, words: set[ast.AST]) -> Iterator[Change]:
    """Every change of this function, in no particular order. words: nodes to leave alone."""
    if all(part in words for part in judging.node.body):
        return
    yield from _statements(source, judging)
    left_alone = words | _in_formatted(judging.node)
    for part in judging.node.body:
        for node in ast.walk(part):
            if node in left_alone:
                continue
            if isinstance(node, ast.Compare):
                yield from _comparisons(source, node)
                yield from bounds.of_comparison(source, node)
            elif isinstance(node, ast.Call):
                yield from bounds.of_call(source, node)
            elif isinstance(node, ast.BoolOp):
                yield _joined_otherwise(source, node)
            elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
                yield _without_not(source, node)


def _statements(source: Source, judging: Judging) -> Iterator[Change]:
    """Remove statements that fail: one at a time, and all of them by returning first.

    If only one statement fails, both are the same; then only return first.
    """
    body = _after_docstring(judging.node)
    found = [node for part in body for node in ast.walk(part) if _fails(node)]
    if (judging.is_check or found) and isinstance(judging.node, ast.FunctionDef) and _gives_nothing(body):
        yield _without(source, body[0], Operator.RETURN, b"return")
        if len(found) < 2:
            return
    for node in found:
        if isinstance(node, ast.Raise):
            yield _without(source, node, Operator.RAISE)
        elif isinstance(node, ast.Expr):
            yield _without(source, node, Operator.EXPECT)


def _fails(node: ast.AST) -> bool:
    """Whether this statement may fail because of what the learner did."""
    if isinstance(node, ast.Raise):
        return isinstance(node.exc, ast.Call) and ast.unparse(node.exc.func) == "Failure"
    value = node.value if isinstance(node, ast.Expr | ast.Assign | ast.Return) else None
    return isinstance(value, ast.Call) and called(value).startswith("expect_")


def called(node: ast.Call) -> str:
    """The last part of the name that is called."""
    return ast.unparse(node.func).rpartition(".")[2]


def _after_docstring(node: ast.FunctionDef | ast.ClassDef) -> list[ast.stmt]:
    documented = ast.get_docstring(node, clean=False) is not None
    return node.body[1:] if documented else node.body


def _gives_nothing(body: list[ast.stmt]) -> bool:
    every = (node for part in body for node in ast.walk(part))
    return bool(body) and not any(isinstance(node, ast.Return) and node.value for node in every)


def _without(source: Source, node: ast.stmt, operator: Operator, instead: bytes = b"pass") -> Change:
    start, end = source.start(node), source.end(node)
    return Change(operator, start, end, instead + _NEWLINE * source.text.count(_NEWLINE, start, end))


def _comparisons(source: Source, node: ast.Compare) -> Iterator[Change]:
    for (left, right), operator in zip(pairwise([node.left, *node.comparators]), node.ops, strict=True):
        yield _compared(source, left, right, Operator.COMPARISON, _TURNED[type(operator)])
        moved = _MOVED.get(type(operator))
        if moved and (bounds.is_whole(source, left) or bounds.is_whole(source, right)):
            yield _compared(source, left, right, Operator.BOUNDARY, moved)


def _compared(source: Source, left: ast.expr, right: ast.expr, operator: Operator, new: str) -> Change:
    between = source.end(left)
    found = _COMPARES.search(source.text, between, source.start(right))
    assert found is not None
    lines = source.text.count(_NEWLINE, found.start(), found.end())
    return Change(operator, found.start(), found.end(), new.encode() + _NEWLINE * lines)


def _joined_otherwise(source: Source, node: ast.BoolOp) -> Change:
    """The parts joined with the other operator, in parentheses, because `or` binds less strongly."""
    pattern, other = _JOINS[type(node.op)]
    parts = [source.text[source.start(node) : source.end(node.values[0])]]
    for value, following in pairwise(node.values):
        between = source.text[source.end(value) : source.start(following)]
        parts.append(pattern.sub(other, between, count=1))
        parts.append(source.text[source.start(following) : source.end(following)])
    parts.append(source.text[source.end(node.values[-1]) : source.end(node)])
    new = b"(" + b"".join(parts) + b")"
    return Change(Operator.AND_OR, source.start(node), source.end(node), new)


def _without_not(source: Source, node: ast.UnaryOp) -> Change:
    start = source.start(node)
    found = re.compile(rb"not[ \t]*").match(source.text, start)
    assert found is not None
    return Change(Operator.NOT, start, found.end(), b"")


def _in_formatted(node: ast.AST) -> set[ast.AST]:
    """Nodes in f-strings: before Python 3.12, their places in the text are wrong."""
    formatted = (one for one in ast.walk(node) if isinstance(one, ast.JoinedStr))
    return {inner for one in formatted for inner in ast.walk(one)}
