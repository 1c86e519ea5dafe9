"""What a recording was made by, as a digest: whether old evidence is what today's scenario would record.

The digest covers the source of the scenario's function and of all that it uses, followed by name through
its module, the modules beside it and those of `course.grading`: helpers, constants, and files below the
graders' folder that it names (probes); the module of its mystery; and which files of the course home are
kept. Comments, docstrings, formatting and order do not count, and neither do the checks, their titles and
their points: those may change while the evidence stays as it is. What the arena itself records is no part
of it either: a recording that cannot be read any more is of another format (`mcap_file.OtherFormat`).
"""

from __future__ import annotations

import ast
import contextlib
import hashlib
from collections.abc import Iterator, Sequence
from pathlib import Path

from course.errors import OurFault
from course.grading.definitions import Definitions, normal, parsed
from course.grading.mystery.author import Mystery

# Of the arguments of `Grader(...)`, this one says nothing of what is recorded.
_POINTS = "builds"


def scenario_digest(grader: Path, exercise: str, looks_at: Sequence[str]) -> str:
    """Digest of what determines the evidence on this exercise; empty when a module cannot be read.

    grader: its module. looks_at: files, folders and patterns of the course home that become evidence.
    """
    try:
        parts = [*_scenario(grader, exercise), *_mystery(grader, exercise), *sorted(looks_at)]
    except (OSError, SyntaxError, ValueError, RecursionError):
        return ""
    return hashlib.sha256("\n\0".join(parts).encode()).hexdigest()


def _scenario(grader: Path, exercise: str) -> Iterator[str]:
    tree = parsed(grader)
    declared = _declaration(tree, exercise)
    if declared is None:  # it was made in some other way: anything may belong to it
        yield ast.unparse(normal(tree))
        return
    name, arguments = declared
    yield from arguments
    used = Definitions(grader.parent)
    for function in _scenarios(tree, name):
        used.follow(grader, function)
    yield from sorted(used.texts)
    yield from _files_named(grader.parent, used.strings)


def _declaration(tree: ast.Module, exercise: str) -> tuple[str, list[str]] | None:
    """Of `name = Grader("exercise", ros=False)`: the name, and the arguments that matter."""
    for node in tree.body:
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Call) and node.value.args:
            call, target, first = node.value, node.targets[0], node.value.args[0]
            if ast.unparse(call.func).endswith("Grader") and ast.unparse(first) == repr(exercise):
                kept = [ast.unparse(one) for one in call.keywords if one.arg != _POINTS]
                return ast.unparse(target), sorted(kept)
    return None


def _scenarios(tree: ast.Module, grader: str) -> Iterator[str]:
    """The names of the functions that are decorated with the grader's `scenario`, or given to it."""
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef) and any(_decorates(one, grader) for one in node.decorator_list):
            yield node.name
        elif isinstance(node, ast.Call) and _decorates(node.func, grader):
            yield from (one.id for one in ast.walk(node) if isinstance(one, ast.Name))


def _decorates(node: ast.expr, grader: str) -> bool:
    return isinstance(node, ast.Attribute) and node.attr == "scenario" and ast.unparse(node.value) == grader


def _mystery(grader: Path, exercise: str) -> Iterator[str]:
    with contextlib.suppress(OurFault):  # it has none
        yield ast.unparse(normal(parsed(Mystery(exercise, str(grader)).file)))


def _files_named(folder: Path, strings: set[str]) -> Iterator[str]:
    """Texts of files right below a folder of the graders' folder whose names the scenario says."""
    for file in sorted(folder.glob("*/*")):
        if file.name in strings and file.is_file():
            yield file.read_text(encoding="utf-8", errors="replace")
