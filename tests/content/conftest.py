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
