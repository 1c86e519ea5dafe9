"""Where in the learner's Python files something is called, read from the syntax tree."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass

from course.evidence.sources import Sources
from course.feedback import Location


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


def calls(sources: Sources, name: str) -> tuple[Call, ...]:
    """All calls of a function or method of this name (`create_timer`), file by file."""
    return tuple(
        Call(Location(file, node.lineno), tuple(node.args), {k.arg: k.value for k in node.keywords if k.arg})
        for file, tree in _trees(sources)
        for node in ast.walk(tree)
        if isinstance(node, ast.Call) and called_name(node) == name
    )


def called_name(node: ast.Call) -> str:
    """`spin` for both `rclpy.spin(...)` and `spin(...)`."""
    if isinstance(node.func, ast.Attribute):
        return node.func.attr
    return node.func.id if isinstance(node.func, ast.Name) else ""


def number(node: ast.expr | None) -> float | None:
    """The value of a literal number."""
    if isinstance(node, ast.Constant) and isinstance(node.value, int | float):
        return float(node.value)
    return None


def text_places(sources: Sources, text: str) -> tuple[Location, ...]:
    """Lines of the learner's code that hold this text."""
    return tuple(
        Location(file, number)
        for file, content in sources.files.items()
        for number, line in enumerate(content.splitlines(), start=1)
        if text in line
    )


def _trees(sources: Sources) -> Iterator[tuple[str, ast.Module]]:
    for file, text in sources.files.items():
        if file.endswith(".py") and "/test/" not in file and not file.endswith("/setup.py"):
            try:
                yield file, ast.parse(text)
            except (SyntaxError, ValueError):  # shown by the traceback of the program itself
                continue
