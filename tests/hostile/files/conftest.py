"""Homes with hostile files: laid, changed by a test, and graded."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from tests.hostile.world import Graded, World, graded, lay_world

GradeHome = Callable[..., Graded]


@pytest.fixture
def grade_home(
    open_place: Path, course_copy: Path, store: Path, tmp_path: Path, worlds: list[World], untouched: None
) -> GradeHome:
    """As `grade`; `change(world)` does to the home what files alone cannot, such as making links."""

    def in_new_world(
        files: Mapping[str, str | bytes],
        exercise: str = "18-publisher",
        *,
        guarantee: str,
        change: Callable[[World], None] = lambda world: None,
        local: bool = True,
    ) -> Graded:
        folder = Path(tempfile.mkdtemp(dir=open_place))
        world = lay_world(folder, course_copy, store, exercise, files)
        worlds.append(world)
        change(world)
        evidence = tmp_path / f"evidence-{len(worlds)}" / "evidence.mcap"
        return graded(world, exercise, evidence, guarantee=guarantee, local=local)

    return in_new_world
