"""Finds an exercise's grader, mystery, and questions, without pytest."""

from __future__ import annotations

import contextlib
import importlib.util
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import TypeVar

from course.arena.mystery_module import seed_for
from course.content import Exercise, Question
from course.errors import OurFault
from course.grading.author import Grader
from course.grading.mystery import Mystery, resolved

_Declared = TypeVar("_Declared", Grader, Mystery)


def load_grader(file: Path, exercise: str) -> Grader:
    """The `Grader` of this exercise. Raises OurFault if there is none, and whatever the module raises."""
    grader = declared(load_module(file), Grader, exercise)
    if grader is None:
        raise OurFault(f"no grader in {file.name} judges {exercise}")
    return grader


def load_module(file: Path) -> ModuleType:
    """Run a grader module. Raises OurFault if it is not a module, and whatever the module raises."""
    spec = importlib.util.spec_from_file_location(f"ros2course_{file.stem}", file)
    if spec is None or spec.loader is None:
        raise OurFault(f"{file} is not a Python module")
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # where the module's dataclasses look for it
    with _modules_beside(file.parent):
        spec.loader.exec_module(module)
    return module


@contextlib.contextmanager
def _modules_beside(folder: Path) -> Iterator[None]:
    """Allow importing modules from the folder: `from lib.counts import expect_counting`.

    They are removed from sys.modules afterward, because another course may use the same names.
    """
    names = {path.stem for path in folder.iterdir()} if folder.is_dir() else set()
    others = _taken(names)
    sys.path.insert(0, str(folder))
    try:
        yield
    finally:
        sys.path.remove(str(folder))
        _taken(names)
        sys.modules.update(others)


def _taken(names: set[str]) -> dict[str, ModuleType]:
    """Remove these modules and their submodules from sys.modules."""
    found = [name for name in sys.modules if name.partition(".")[0] in names]
    return {name: sys.modules.pop(name) for name in found}


def declared(module: ModuleType, kind: type[_Declared], exercise: str) -> _Declared | None:
    """The Grader or Mystery of this exercise in a grader module, or None."""
    found = (value for value in vars(module).values() if isinstance(value, kind))
    return next((value for value in found if value.exercise == exercise), None)


def runs_programs(exercise: Exercise) -> bool:
    """Whether the exercise has a grader; if not, only its questions are judged."""
    if not exercise.questions:
        return True
    if not exercise.grader.is_file():
        return False
    return declared(load_module(exercise.grader), Grader, exercise.id) is not None


def questions_for(exercise: Exercise, seed: int | None) -> tuple[Question, ...]:
    """seed: the learner's own; only needed for a mystery. Raises OurFault for errors in the course."""
    mystery = mystery_of(exercise)
    if mystery is None:
        return exercise.questions
    if seed is None:
        raise OurFault(f"{exercise.id} is a mystery, and no seed was given to draw it from")
    return resolved(exercise, mystery, mystery.draw(seed_for(exercise.id, seed)))


def mystery_of(exercise: Exercise) -> Mystery | None:
    """The mystery that the exercise's grader module declares; None if there is none."""
    if exercise.play is None:
        return None
    mystery = declared(load_module(exercise.grader), Mystery, exercise.id)
    if mystery is None and any(question.computed for question in exercise.questions):
        raise OurFault(f"{exercise.grader.name} has no `Mystery` of {exercise.id}")
    return mystery
