"""The file in which `play` keeps a learner's acts, so that a later check can see them.

It is the learner's to edit, as all of their home is: it saves an honest learner from doing things
twice, and proves nothing about a dishonest one.
"""

from __future__ import annotations

import json
import os
from dataclasses import asdict
from pathlib import Path
from typing import Any

from course.evidence.acts import Act
from course.rosenv.files import write_atomic

SCHEMA_VERSION = 1
MAX_ACTS = 200
MAX_TEXT = 1000
MAX_BYTES = 1024 * 1024


def acts_file(state: Path, exercise: str) -> Path:
    """Where the acts of an exercise are kept, in a course home's own folder."""
    return state / "acts" / f"{exercise}.json"


def read_acts(file: Path) -> tuple[Act, ...]:
    """The acts in the file; none when it is missing, too large or not one of ours."""
    try:
        descriptor = os.open(file, os.O_RDONLY | os.O_NONBLOCK | os.O_NOFOLLOW | os.O_CLOEXEC)
        with os.fdopen(descriptor, "rb") as stream:
            data = json.loads(stream.read(MAX_BYTES))
        return tuple(_act(item) for item in data["acts"][:MAX_ACTS])
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return ()


def write_acts(file: Path, exercise: str, acts: tuple[Act, ...]) -> None:
    data = {"schema": SCHEMA_VERSION, "exercise": exercise, "acts": [asdict(act) for act in acts]}
    write_atomic(file, json.dumps(data, indent=2) + "\n")


def _act(item: dict[str, Any]) -> Act:
    return Act(str(item["name"])[:MAX_TEXT], str(item.get("detail", ""))[:MAX_TEXT])
