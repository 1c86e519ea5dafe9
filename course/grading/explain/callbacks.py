"""Functions that ROS calls back, and what happens inside them."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass

from course.evidence.sources import Sources
from course.feedback import Location
from course.grading.explain.python_code import called_name, calls, trees
from course.grading.explain.timers import TAKERS

_Def = ast.FunctionDef | ast.AsyncFunctionDef


@dataclass(frozen=True)
class Function:
    """A function or method of the learner's."""

    file: str
    node: _Def

    @property
    def where(self) -> Location:
        return Location(self.file, self.node.lineno)

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of its positional parameters, without `self`."""
        names = tuple(argument.arg for argument in self.node.args.args)
        return names[1:] if names[:1] in (("self",), ("cls",)) else names

    def calls(self, name: str) -> tuple[Location, ...]:
        """Where it calls a function or method of this name."""
        return tuple(
            Location(self.file, node.lineno) for node in _called(self.node) if called_name(node) == name
        )


def callbacks(sources: Sources, *makers: str) -> tuple[Function, ...]:
    """The learner's functions that are handed to `create_timer`, `create_service` and so on.

    makers: only what is handed to these; by default to any that takes a callback.
    """
    names = {
        name
        for maker in makers or TAKERS
        for call in calls(sources, maker)
        for name in _names(call.argument(TAKERS[maker], "callback"))
    }
    return tuple(found for found in _functions(sources) if found.node.name in names)


def in_callbacks(sources: Sources, name: str) -> tuple[Location, ...]:
    """Where a function of this name is called in a callback, or in a function that a callback calls."""
    every = _functions(sources)
    reached = list(callbacks(sources))
    for function in reached:  # grows on the way
        called = {called_name(node) for node in _called(function.node)}
        reached += [found for found in every if found.node.name in called and found not in reached]
    return tuple(sorted({place for one in reached for place in one.calls(name)}, key=str))


def _functions(sources: Sources) -> list[Function]:
    return [
        Function(file, node)
        for file, tree in trees(sources)
        for node in ast.walk(tree)
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
    ]


def _called(node: ast.AST) -> Iterator[ast.Call]:
    return (inner for inner in ast.walk(node) if isinstance(inner, ast.Call))


def _names(node: ast.expr | None) -> set[str]:
    """Names in `self.tick`, `partial(tick, 1)`, `lambda: self.tick()`."""
    inner = list(ast.walk(node)) if node else []
    attributes = {part.attr for part in inner if isinstance(part, ast.Attribute)}
    return attributes | {part.id for part in inner if isinstance(part, ast.Name)}
