"""Ways to break a copy of the small course."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

Change = Callable[[str, str, str], Path]


@pytest.fixture
def change(small_course: Path) -> Change:
    """`change(file, old, new)`: replace a text that must occur in a file of the small course."""

    def replace(name: str, old: str, new: str) -> Path:
        file = small_course / name
        text = file.read_text()
        assert old in text
        file.write_text(text.replace(old, new, 1))
        return file

    return replace


@pytest.fixture
def lesson(change: Change) -> Callable[[str, str], Path]:
    """`lesson(old, new)`: the same for lesson.yaml."""
    return lambda old, new: change("chapters/04-lanterns/lesson.yaml", old, new)


@pytest.fixture
def mistakes(change: Change) -> Callable[[str, str], Path]:
    """`mistakes(old, new)`: the same for mistakes.yaml."""
    return lambda old, new: change("chapters/04-lanterns/mistakes.yaml", old, new)


@pytest.fixture
def steps(small_course: Path) -> Callable[[str, str], Path]:
    """Give the lesson two steps, and the exercises these values of `step` ("": none)."""

    def give(first: str, second: str) -> Path:
        chapter = small_course / "chapters/04-lanterns"
        with (chapter / "lesson.md").open("a") as lesson:
            lesson.write("\n## One\n\nof one\n## Two\n\nof two\n")
        file = chapter / "lesson.yaml"
        for name, step in (("04-light", first), ("04-dim", second)):
            if step:
                entry = f"  - id: {name}\n"
                file.write_text(file.read_text().replace(entry, f"{entry}    step: {step}\n"))
        return small_course

    return give
