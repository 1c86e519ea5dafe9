"""Where in the learner's Python files something is called, read from the syntax tree."""

from __future__ import annotations

import ast
import warnings
from collections.abc import Iterator
from dataclasses import dataclass

from course.evidence.sources import Sources
from course.feedback import Location

# No period of time; and a whole number may be too large to become a float.
_HUGE = 1e18


@dataclass(frozen=True)
class Call:
    """One call in the source: where it is, and its positional and keyword arguments."""

    where: Location
    args: tuple[ast.expr, ...]
    keywords: dict[str, ast.expr]

    def argument(self, position: int, keyword: str) -> ast.expr | None:
        """The argument, however it is passed."""
        if keyword in self.keywords:
            return self.keywords[keyword]
        return self.args[position] if position < len(self.args) else None


def parsed(text: str) -> ast.Module | None:
    """The syntax tree, or None when Python cannot read the file: its own traceback says why."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # an escape such as "\d" is not what is looked for here
        try:
            return ast.parse(text)
        except (SyntaxError, ValueError, RecursionError, MemoryError):
            return None


def functions(sources: Sources, name: str) -> tuple[ast.FunctionDef | ast.AsyncFunctionDef, ...]:
    """All functions and methods of this name that the learner defines."""
    return tuple(
        node
        for _, tree in trees(sources)
        for node in ast.walk(tree)
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef) and node.name == name
    )


def calls(sources: Sources, name: str) -> tuple[Call, ...]:
    """All calls of a function or method of this name (`create_timer`), file by file."""
    return tuple(
        Call(Location(file, node.lineno), tuple(node.args), {k.arg: k.value for k in node.keywords if k.arg})
        for file, tree in trees(sources)
        for node in ast.walk(tree)
        if isinstance(node, ast.Call) and called_name(node) == name
    )


def called_name(node: ast.Call) -> str:
    """`spin` for both `rclpy.spin(...)` and `spin(...)`."""
    if isinstance(node.func, ast.Attribute):
        return node.func.attr
    return node.func.id if isinstance(node.func, ast.Name) else ""


def number(sources: Sources, node: ast.expr | None) -> float | None:
    """The value of a number in the source: a literal, or a name that is given one somewhere."""
    if isinstance(node, ast.Constant) and isinstance(node.value, int | float):
        return float(node.value) if abs(node.value) < _HUGE else None
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div | ast.Mult):
        left, right = number(sources, node.left), number(sources, node.right)
        if left is None or not right:
            return None
        return left / right if isinstance(node.op, ast.Div) else left * right
    name = _plain_name(node)
    values = (number(sources, value) for value in _assigned(sources, name)) if name else ()
    return next((value for value in values if value is not None), None)


def _plain_name(node: ast.AST | None) -> str | None:
    """`period` for both `period` and `self.period`."""
    if isinstance(node, ast.Attribute):
        return node.attr
    return node.id if isinstance(node, ast.Name) else None


def _assigned(sources: Sources, name: str) -> Iterator[ast.expr]:
    """Literals that are assigned to this name anywhere (other names are not followed)."""
    for _, tree in trees(sources):
        for node in ast.walk(tree):
            targets = node.targets if isinstance(node, ast.Assign) else [getattr(node, "target", None)]
            value = getattr(node, "value", None)
            assigns = isinstance(node, ast.Assign | ast.AnnAssign) and _literal(value)
            if assigns and value is not None and any(_plain_name(target) == name for target in targets):
                yield value


def _literal(node: ast.expr | None) -> bool:
    return node is not None and all(
        not isinstance(part, ast.Name | ast.Attribute | ast.Call) for part in ast.walk(node)
    )


def text_places(sources: Sources, text: str) -> tuple[Location, ...]:
    """Lines of the learner's code that hold this text."""
    return tuple(
        Location(file, number)
        for file, content in sources.files.items()
        for number, line in enumerate(content.splitlines(), start=1)
        if text in line
    )


def trees(sources: Sources) -> Iterator[tuple[str, ast.Module]]:
    """Each of the learner's Python files that can be read, without setup.py and the tests."""
    for file, text in sources.files.items():
        if file.endswith(".py") and "/test/" not in file and not file.endswith("/setup.py"):
            tree = parsed(text)
            if tree is not None:
                yield file, tree
