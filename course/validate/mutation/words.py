"""What in a grader's functions only makes texts for the learner: to change it weakens no judgement.

That is: what a `Feedback` is made of, and other arguments that are texts (`advice=`); local variables, and
functions of the module, that are used nowhere else. An `if` that only raises a fault of ours is left alone,
too: no learner's mistake leads there.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator, Sequence

from course.validate.mutation.source import Defined

_MADE = frozenset({"Feedback", "Location"})
_TEXTS = frozenset({"advice", "remedy", "summary", "what", "near_miss", "details", "where"})


def words(functions: Sequence[Defined]) -> set[ast.AST]:
    """All nodes of these functions that are only about words."""
    found: set[ast.AST] = set()
    for node in _every(functions):
        found.update(_plainly(node))
    before = -1
    while before != len(found):  # what is used only for words is about words itself
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
    """Whether it raises what is no judgement of the learner's work."""
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
    """An `if` that only chooses between words."""
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
