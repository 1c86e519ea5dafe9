"""Finds the grader of an exercise in its module, without pytest."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType
from typing import TypeVar

from course.content import Exercise
from course.errors import OurFault
from course.grading.author import Grader
from course.grading.mystery import Mystery

_Declared = TypeVar("_Declared", Grader, Mystery)


def load_grader(file: Path, exercise: str) -> Grader:
    """The `Grader` of this exercise. Raises OurFault when the module has none, and what it raises itself."""
    grader = declared(load_module(file), Grader, exercise)
    if grader is None:
        raise OurFault(f"no grader in {file.name} judges {exercise}")
    return grader


def load_module(file: Path) -> ModuleType:
    """Run a grader module. Raises OurFault when it is none, and what it raises itself."""
    spec = importlib.util.spec_from_file_location(f"ros2course_{file.stem}", file)
    if spec is None or spec.loader is None:
        raise OurFault(f"{file} is no Python module")
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # where dataclasses of the module look for it
    spec.loader.exec_module(module)
    return module


def declared(module: ModuleType, kind: type[_Declared], exercise: str) -> _Declared | None:
    """The Grader or Mystery of this exercise in a grader module, or None."""
    found = (value for value in vars(module).values() if isinstance(value, kind))
    return next((value for value in found if value.exercise == exercise), None)


def runs_programs(exercise: Exercise) -> bool:
    """Whether a grader acts for this exercise; else its questions are all there is to judge."""
    if not exercise.questions:
        return True
    if not exercise.grader.is_file():
        return False
    return declared(load_module(exercise.grader), Grader, exercise.id) is not None
