"""A mystery of a course: its module, its seed, and the log of what the learner did.

The module has `draw(seed) -> plan`, which is pure and has everything random in it, and
`play(plan, acts) -> nodes`, which needs ROS. `play` writes the log, which later checks read. Learners can
edit it, like everything in their home. It saves honest learners from doing things twice, and proves nothing
about dishonest ones.
"""

from __future__ import annotations

import hashlib
import importlib.util
import json
import os
import sys
from dataclasses import asdict, dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

from course.errors import OurFault
from course.evidence.acts import Act
from course.files import write_atomic

_BITS = 63
# What the nodes' program prints once all of them are up.
READY = "ready"
SCHEMA_VERSION = 1
MAX_ACTS = 200
MAX_TEXT = 1000
MAX_BYTES = 1024 * 1024


@dataclass(frozen=True)
class MysteryJob:
    """What to play. log: the file for acts; None prints each act as a line of JSON."""

    file: str
    exercise: str
    seed: int
    log: str | None = None


def load_mystery(file: Path) -> ModuleType:
    """Import the file. Raises OurFault if it is not a mystery, and whatever the file itself raises."""
    is_package = file.name == "__init__.py"
    exercise = file.parent.name if is_package else file.stem
    name = f"ros2course_play_{exercise.replace('-', '_')}"
    folders = [str(file.parent)] if is_package else None
    spec = importlib.util.spec_from_file_location(name, file, submodule_search_locations=folders)
    if spec is None or spec.loader is None:
        raise OurFault(f"{file} is not a Python module")
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module  # where dataclasses, and `from . import` in a package, look for it
    spec.loader.exec_module(module)
    for function in ("draw", "play"):
        if not callable(getattr(module, function, None)):
            raise OurFault(f"{file} has no function `{function}`", f"Write `def {function}(...)` in it.")
    return module


def seed_for(exercise: str, seed: int) -> int:
    """The seed of one exercise, from a learner's seed; neither reveals anything about the other."""
    return _number(f"exercise/{exercise}/{seed}")


def seed_of_submission(submission: str) -> int:
    """A seed for a learner who has none, derived from the name of their submission."""
    return _number(f"submission/{submission}")


def _number(text: str) -> int:
    return int.from_bytes(hashlib.sha256(text.encode()).digest()[:8], "big") >> (64 - _BITS)


def log_file(state: Path, exercise: str) -> Path:
    """Where an exercise's acts are kept, in the course's own folder of the home."""
    return state / "acts" / f"{exercise}.json"


def read_log(file: Path) -> tuple[Act, ...]:
    """The acts in the file; empty if it is missing, too large or not ours."""
    try:
        descriptor = os.open(file, os.O_RDONLY | os.O_NONBLOCK | os.O_NOFOLLOW | os.O_CLOEXEC)
        with os.fdopen(descriptor, "rb") as stream:
            data = json.loads(stream.read(MAX_BYTES))
        return tuple(_act(item) for item in data["acts"][:MAX_ACTS])
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return ()


def write_log(file: Path, exercise: str, acts: tuple[Act, ...]) -> None:
    data = {"schema": SCHEMA_VERSION, "exercise": exercise, "acts": [asdict(act) for act in acts]}
    write_atomic(file, json.dumps(data, indent=2) + "\n")


def _act(item: dict[str, Any]) -> Act:
    return Act(str(item["name"])[:MAX_TEXT], str(item.get("detail", ""))[:MAX_TEXT])
