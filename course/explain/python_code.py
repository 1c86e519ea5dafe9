"""Finds calls, functions, and numbers in the learner's Python files, using their syntax trees."""

from __future__ import annotations

import ast
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from itertools import islice

from course.evidence.sources import Sources
from course.model.feedback import Location

# Larger numbers are not periods, and a whole number may be too large for a float.
_HUGE = 1e18
# Limits: characters in a file and in all files; levels of a tree. Each line joined by `+` is a level.
LONGEST, _MOST_TEXT, DEEPEST = 64 * 1024, 256 * 1024, 120
# Limit for calls of one name, because for some of them we search all of the code.
_MOST_CALLS = 50


@dataclass(frozen=True)
class PythonCall:
    """One call in the source: where it is, and its positional and keyword arguments."""

    where: Location
    args: tuple[ast.expr, ...]
    keywords: dict[str, ast.expr]

    def argument(self, position: int, keyword: str) -> ast.expr | None:
        """Return the argument, whether passed by position or by keyword; None if it is missing."""
        if keyword in self.keywords:
            return self.keywords[keyword]
        return self.args[position] if position < len(self.args) else None


@lru_cache(maxsize=64)
def parsed(text: str) -> ast.Module | None:
    """The syntax tree, which must not be changed; None if the file cannot or should not be parsed.

    Python's own traceback explains syntax errors. A deep tree would crash any code that walks it
    recursively, and a large one takes longer to search than a check may.
    """
    tree = read(text) if len(text) <= LONGEST else None
    return tree if isinstance(tree, ast.Module) and not _is_deep(tree) else None


def read(text: str) -> ast.Module | SyntaxError | None:
    """The syntax tree, or what is wrong with the text; None if Python fails in another way."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # an escape such as "\d" does not matter here
        try:
            return ast.parse(text)
        except SyntaxError as error:
            return error
        except (ValueError, RecursionError, MemoryError):
            return None


def _is_deep(tree: ast.AST) -> bool:
    level: list[ast.AST] = [tree]
    for _ in range(DEEPEST):
        level = [child for node in level for child in ast.iter_child_nodes(node)]
        if not level:
            return False
    return True


def functions(sources: Sources, name: str) -> tuple[ast.FunctionDef | ast.AsyncFunctionDef, ...]:
    """Return all of the learner's functions and methods of this name."""
    return tuple(
        node
        for _, node in nodes(sources)
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef) and node.name == name
    )


def function_around(sources: Sources, place: Location | None) -> ast.FunctionDef | None:
    """The innermost function with this line."""
    found = [
        node
        for file, node in nodes(sources)
        if isinstance(node, ast.FunctionDef) and place and place.line and file == place.file
        if node.lineno <= place.line <= (node.end_lineno or 0)
    ]
    return max(found, key=lambda node: node.lineno, default=None)


def last_name(node: ast.AST) -> str:
    """`period` for both `period` and `self.period`."""
    return ast.unparse(node).rpartition(".")[2]


def takes_self(function: ast.FunctionDef | ast.AsyncFunctionDef) -> bool:
    return [one.arg for one in function.args.args[:1]] == ["self"]


def calls(sources: Sources, name: str) -> tuple[PythonCall, ...]:
    """Return calls of a function or method of this name (`create_timer`), file by file, up to a limit."""
    found = (
        PythonCall(
            Location(file, node.lineno), tuple(node.args), {k.arg: k.value for k in node.keywords if k.arg}
        )
        for file, node in nodes(sources)
        if isinstance(node, ast.Call) and called_name(node) == name
    )
    return tuple(islice(found, _MOST_CALLS))


def called_name(node: ast.Call) -> str:
    """`spin` for both `rclpy.spin(...)` and `spin(...)`."""
    if isinstance(node.func, ast.Attribute):
        return node.func.attr
    return node.func.id if isinstance(node.func, ast.Name) else ""


def number(sources: Sources, node: ast.expr | None) -> float | None:
    """The value of a literal number, a product, a quotient, or a variable that is assigned one somewhere."""
    if isinstance(node, ast.Constant) and isinstance(node.value, int | float):
        return float(node.value) if abs(node.value) < _HUGE else None
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div | ast.FloorDiv | ast.Mult):
        left, right = number(sources, node.left), number(sources, node.right)
        if left is None or not right:
            return None
        whole = left // right if isinstance(node.op, ast.FloorDiv) else left / right
        return left * right if isinstance(node.op, ast.Mult) else whole
    name = _plain_name(node)
    values = (number(sources, value) for value in assigned(sources, name)) if name else ()
    return next((value for value in values if value is not None), None)


def _plain_name(node: ast.AST | None) -> str | None:
    """`period` for both `period` and `self.period`."""
    if isinstance(node, ast.Attribute):
        return node.attr
    return node.id if isinstance(node, ast.Name) else None


def number_where(sources: Sources, node: ast.expr | None) -> tuple[Location, ...]:
    """Where the variable that `number` reads gets its value; empty if it reads no variable."""
    name = _plain_name(node)
    found = _assigned(sources, name) if name else ()
    return tuple(where for where, value in found if number(sources, value) is not None)[:1]


def assigned(sources: Sources, name: str) -> Iterator[ast.expr]:
    """Values assigned to this name anywhere, if they contain no other names and no calls."""
    return (value for _, value in _assigned(sources, name))


def _assigned(sources: Sources, name: str) -> Iterator[tuple[Location, ast.expr]]:
    for file, node in nodes(sources):
        targets = node.targets if isinstance(node, ast.Assign) else [getattr(node, "target", None)]
        value = getattr(node, "value", None)
        assigns = isinstance(node, ast.Assign | ast.AnnAssign) and _literal(value)
        if assigns and value is not None and any(_plain_name(target) == name for target in targets):
            yield Location(file, value.lineno), value


def _literal(node: ast.expr | None) -> bool:
    return node is not None and all(
        not isinstance(part, ast.Name | ast.Attribute | ast.Call) for part in ast.walk(node)
    )


def text_places(sources: Sources, text: str) -> tuple[Location, ...]:
    """Return the lines of the learner's code that contain this text."""
    return tuple(
        Location(file, number)
        for file, content in sources.files.items()
        for number, line in enumerate(content.splitlines(), start=1)
        if text in line
    )


def nodes(sources: Sources) -> Iterator[tuple[str, ast.AST]]:
    """Every node in `trees`, each with its file."""
    return ((file, node) for file, tree in trees(sources) for node in ast.walk(tree))


def trees(sources: Sources) -> Iterator[tuple[str, ast.Module]]:
    """Yield each of the learner's readable Python files with its tree, except setup.py and the tests."""
    room = _MOST_TEXT
    for file, text in sources.files.items():
        if file.endswith(".py") and "/test/" not in file and not file.endswith("/setup.py"):
            room -= len(text)
            tree = parsed(text) if room >= 0 else None
            if tree is not None:
                yield file, tree
