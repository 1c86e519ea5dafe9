"""The module of a mystery in a course: `draw(seed) -> plan`, and `play(plan, acts) -> nodes`."""

from __future__ import annotations

import hashlib
import importlib.util
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from course.errors import OurFault

_BITS = 63


@dataclass(frozen=True)
class PlayModule:
    """draw: pure; all that is random in the mystery. play: makes the nodes; needs ROS."""

    draw: Callable[[int], Any]
    play: Callable[..., Any]


def load_play(file: Path) -> PlayModule:
    """Import the file. Raises OurFault when it is no mystery, and what the file raises itself."""
    is_package = file.name == "__init__.py"
    exercise = file.parent.name if is_package else file.stem
    name = f"ros2course_play_{exercise.replace('-', '_')}"
    folders = [str(file.parent)] if is_package else None
    spec = importlib.util.spec_from_file_location(name, file, submodule_search_locations=folders)
    if spec is None or spec.loader is None:
        raise OurFault(f"{file} is no Python module")
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module  # dataclasses, and `from . import` in a package, look for it there
    spec.loader.exec_module(module)
    for function in ("draw", "play"):
        if not callable(getattr(module, function, None)):
            raise OurFault(f"{file} has no function `{function}`", f"Write `def {function}(...)` in it.")
    return PlayModule(module.draw, module.play)


def seed_for(exercise: str, seed: int) -> int:
    """The seed of one exercise out of a learner's: none of the two tells anything of the other's."""
    return _number(f"exercise/{exercise}/{seed}")


def seed_of_submission(submission: str) -> int:
    """A learner's seed for those who have none: made of what names their submission."""
    return _number(f"submission/{submission}")


def _number(text: str) -> int:
    return int.from_bytes(hashlib.sha256(text.encode()).digest()[:8], "big") >> (64 - _BITS)
