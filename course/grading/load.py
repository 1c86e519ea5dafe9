"""Finds the grader of an exercise in its module, without pytest."""

from __future__ import annotations

import importlib.util
from pathlib import Path

from course.errors import OurFault
from course.grading.author import Grader


def load_grader(file: Path, exercise: str) -> Grader:
    """The `Grader` of this exercise. Raises OurFault when the module has none, and what it raises itself."""
    spec = importlib.util.spec_from_file_location(f"ros2course_{file.stem}", file)
    if spec is None or spec.loader is None:
        raise OurFault(f"{file} is no Python module")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    for value in vars(module).values():
        if isinstance(value, Grader) and value.exercise == exercise:
            return value
    raise OurFault(f"no grader in {file.name} judges {exercise}")
