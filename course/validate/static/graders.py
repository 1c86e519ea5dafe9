"""Grader modules: the checks that they declare, read without running them, and the result of loading them.

Loading a module stops at its first wrong check; reading it finds all of them, with their lines.
"""

from __future__ import annotations

import ast
import contextlib
import signal
import threading
import traceback
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from types import ModuleType
from typing import NoReturn, TypeVar

from course.errors import CourseError
from course.grading import author
from course.grading.author import BUILDS, Grader
from course.grading.load import load_module
from course.grading.mystery import Mystery
from course.spelling import in_one_line
from course.validate import Finding


@dataclass(frozen=True)
class DeclaredCheck:
    """One `@grader.check(...)`. needs: None if it is not a literal; then it is not judged."""

    id: str
    line: int
    needs: tuple[str, ...] | None
    can_fail: bool = True


@dataclass
class Declaration:
    """One `Grader("18-publisher")`. whole: whether all ids are literals, so that `checks` is complete."""

    exercise: str
    line: int
    builds: bool
    checks: list[DeclaredCheck] = field(default_factory=list)
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
    """String constants of the module: `NAME = "text"`."""
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
    owner.checks.append(DeclaredCheck(name, call.lineno, needs, function is None or _can_fail(function)))


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
    """False for a check that only raises NotApplicable and calls nothing that could raise."""
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
    """The module's syntax tree; None if it cannot be parsed, which loading it will report."""
    try:
        return ast.parse(file.read_bytes(), str(file))
    except (OSError, SyntaxError, ValueError, RecursionError):
        return None


_Kind = TypeVar("_Kind", Grader, Mystery)


@dataclass(frozen=True)
class GraderModule:
    """A grader module. fault: why it cannot be loaded; then graders and mysteries are empty.

    by_declaration: whether the cause is a wrong declaration of a check; `grader_rules` finds all of these.
    """

    file: Path
    declared: tuple[Declaration, ...]
    graders: tuple[Grader, ...] = ()
    mysteries: tuple[Mystery, ...] = ()
    fault: Finding | None = None
    by_declaration: bool = False

    def of(self, exercise: str) -> Grader | None:
        return next((one for one in self.graders if one.exercise == exercise), None)

    def declaration(self, exercise: str) -> Declaration | None:
        return next((one for one in self.declared if one.exercise == exercise), None)

    def line_of(self, exercise: str, check: str) -> int | None:
        """The line of the check's declaration or, if that is not known, of its grader."""
        declared = self.declaration(exercise)
        return declared.line_of(check) if declared else None


LOAD_TIME = 20.0


class Endless(BaseException):
    """Not an Exception, so no `except Exception` in a grader module catches it."""


def read_graders(file: Path) -> GraderModule:
    tree = parsed(file)
    declared = declarations(tree) if tree else ()
    try:
        with _bounded(LOAD_TIME):
            module = load_module(file)
    except (Exception, SystemExit, Endless) as error:  # noqa: BLE001 - an author's module may raise anything
        fault, by_declaration = _fault(file, error), _is_of_declaration(error)
        return GraderModule(file, declared, fault=fault, by_declaration=by_declaration)
    return GraderModule(file, declared, _in(module, Grader), _in(module, Mystery))


@contextlib.contextmanager
def _bounded(seconds: float) -> Iterator[None]:
    """Raise Endless in code that takes too long. Only the main thread can be interrupted."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def end(number: int, frame: object) -> NoReturn:
        raise Endless(f"importing it did not end within {seconds:g} s")

    before = signal.signal(signal.SIGALRM, end)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def _in(module: ModuleType, kind: type[_Kind]) -> tuple[_Kind, ...]:
    return tuple(dict.fromkeys(value for value in vars(module).values() if isinstance(value, kind)))


def _fault(file: Path, error: BaseException) -> Finding:
    if isinstance(error, SyntaxError):
        return _syntax_error(file, error)
    named = "" if isinstance(error, Endless) else f"{type(error).__name__}: "
    what = error.what if isinstance(error, CourseError) else f"{named}{error}"
    step = "correct it: until then none of the chapter's exercises can be graded"
    where, line = _place(file, error)
    return Finding(where, line, f"the grader cannot be loaded: {in_one_line(what)}", step)


def _syntax_error(file: Path, error: SyntaxError) -> Finding:
    named = Path(error.filename) if error.filename else file
    where = named if named.is_file() else file
    what = f"the grader is not valid Python: {in_one_line(error.msg)}"
    return Finding(where, error.lineno or None, what, "correct the line, or the one before it")


def _place(file: Path, error: BaseException) -> tuple[Path, int | None]:
    """The innermost traceback line in the graders' folder."""
    frames = traceback.extract_tb(error.__traceback__)
    ours = [frame for frame in frames if Path(frame.filename).is_relative_to(file.parent)]
    return (Path(ours[-1].filename), ours[-1].lineno) if ours else (file, None)


def _is_of_declaration(error: BaseException) -> bool:
    frames = traceback.extract_tb(error.__traceback__)
    return isinstance(error, CourseError) and bool(frames) and frames[-1].filename == author.__file__
