"""A small course that can be proven, and ways to break a copy of it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.content import open_course
from course.validate.static.commands import Complaint
from course.validate.static.rules import findings

GRADER = '''\
"""The graders of the lanterns."""

from course.api import Recording
from course.api import Grader

light = Grader("04-light", builds=None)
dim = Grader("04-dim", builds=None)


@light.check("is_bright", "it is bright")
def is_bright(recording: Recording) -> None:
    raise NotImplementedError


@dim.check("there", "the file is there")
def there(recording: Recording) -> None:
    raise NotImplementedError


@dim.check("dims", "it dims", needs="there")
def dims(recording: Recording) -> None:
    raise NotImplementedError
'''

Change = Callable[[str, str, str], None]
Tell = Callable[..., list[str]]


@pytest.fixture
def root(small_course: Path) -> Path:
    (small_course / "graders/ch04_lanterns.py").write_text(GRADER)
    mistakes = small_course / "chapters/04-lanterns/mistakes.yaml"
    mistakes.write_text(
        mistakes.read_text().replace("caught_by: dims", "caught_by: there\n    also_fails: [dims]")
    )
    return small_course


@pytest.fixture
def change(root: Path) -> Change:
    """`change(file, old, new)`: replace a text that must occur; with `old` empty, write a whole file."""

    def replace(name: str, old: str, new: str) -> None:
        file = root / name
        text = file.read_text() if old else ""
        assert old in text
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text.replace(old, new, 1) if old else new)

    return replace


@pytest.fixture
def tell(root: Path) -> Tell:
    """What is found, each as `file:line: what`. The file is relative to the course."""

    def told(*ids: str, own_command: Complaint | None = None, folder: Path = root) -> list[str]:
        course = open_course(folder)
        exercises = [one for one in course.readable_exercises() if not ids or one.id in ids]
        found = findings(course, exercises, own_command)
        return [f"{one.file.relative_to(folder)}:{one.line}: {one.what}" for one in found]

    return told
