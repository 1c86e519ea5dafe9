"""Loads a grader module, and says where and why that fails."""

from __future__ import annotations

import traceback
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import TypeVar

from course.errors import CourseError
from course.grading import author
from course.grading.author import Grader
from course.grading.load import load_module
from course.grading.mystery import Mystery
from course.validate.model import Finding
from course.validate.texts.graders.declared import Declaration, declarations, parsed

_Kind = TypeVar("_Kind", Grader, Mystery)


@dataclass(frozen=True)
class Graders:
    """A grader module. fault: why it cannot be loaded; then graders and mysteries are empty.

    by_declaration: whether the fault is one of a check's declaration, as `rules` find them, all of them.
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
        """Where the check is declared; where it cannot be told, where its grader is."""
        declared = self.declaration(exercise)
        return declared.line_of(check) if declared else None


def read_graders(file: Path) -> Graders:
    tree = parsed(file)
    declared = declarations(tree) if tree else ()
    try:
        module = load_module(file)
    except (Exception, SystemExit) as error:  # noqa: BLE001 - a module of the author: it may raise anything
        fault, by_declaration = _fault(file, error), _is_of_declaration(error)
        return Graders(file, declared, fault=fault, by_declaration=by_declaration)
    return Graders(file, declared, _in(module, Grader), _in(module, Mystery))


def _in(module: ModuleType, kind: type[_Kind]) -> tuple[_Kind, ...]:
    """Each once, under whichever names the module knows it."""
    return tuple(dict.fromkeys(value for value in vars(module).values() if isinstance(value, kind)))


def _fault(file: Path, error: BaseException) -> Finding:
    if isinstance(error, SyntaxError):
        return _syntax_error(file, error)
    what = error.what if isinstance(error, CourseError) else f"{type(error).__name__}: {error}"
    step = "correct it: until then none of the chapter's exercises can be graded"
    where, line = _place(file, error)
    return Finding(where, line, f"the grader cannot be loaded: {_one_line(what)}", step)


def _syntax_error(file: Path, error: SyntaxError) -> Finding:
    named = Path(error.filename) if error.filename else file
    where = named if named.is_file() else file
    what = f"the grader is no Python: {_one_line(error.msg)}"
    return Finding(where, error.lineno or None, what, "correct the line, or the one before it")


def _place(file: Path, error: BaseException) -> tuple[Path, int | None]:
    """The innermost line in the graders' folder."""
    frames = traceback.extract_tb(error.__traceback__)
    ours = [frame for frame in frames if Path(frame.filename).is_relative_to(file.parent)]
    return (Path(ours[-1].filename), ours[-1].lineno) if ours else (file, None)


def _is_of_declaration(error: BaseException) -> bool:
    frames = traceback.extract_tb(error.__traceback__)
    return isinstance(error, CourseError) and bool(frames) and frames[-1].filename == author.__file__


def _one_line(text: str) -> str:
    return " ".join(text.split())
