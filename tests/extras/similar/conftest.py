"""Comparing a folder on the small course."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.content import open_course
from course_similar import Solutions, Wanted, find_similar
from course_similar.comparison import Comparison

Compare = Callable[..., Comparison]


@pytest.fixture
def compared(tmp_path: Path, small_course: Path) -> Compare:
    """`compared(folder)`: what is similar in it."""

    def run(folder: Path, wanted: Wanted | None = None, solutions: Solutions = Solutions.ALONE) -> Comparison:
        course = open_course(small_course)
        return find_similar(
            folder, tmp_path / "opened", course, wanted or Wanted(), solutions, lambda _: None
        )

    return run
