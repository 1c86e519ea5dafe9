"""Hostile submissions: a world to attack for each test, and one call that grades an attack in it."""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path

import pytest

from course.arena.lateness import Lateness, measured_lateness
from course.content import open_course
from course.evidence.timeline import Timeline
from tests.hostile.world import SECRET, Grade, Graded, World, graded, lay_world, open_to_all

# Bytecode of our own graders would appear in the world, as if a submission had written it.
os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
sys.dont_write_bytecode = True


@pytest.fixture(scope="session")
def open_place() -> Iterator[Path]:
    """A folder for all of a run, which any user can reach; pytest's own are closed to all but one."""
    with tempfile.TemporaryDirectory(prefix="hostile-") as name:
        Path(name).chmod(0o755)
        yield Path(name)


@pytest.fixture(scope="session")
def course_copy(open_place: Path) -> Path:
    """The real course, with a canary beside each solution and grader, and no permission that protects it."""
    root, copy = open_course().root, open_place / "course"
    for part in ("chapters", "graders", "solutions"):
        shutil.copytree(root / part, copy / part, ignore=shutil.ignore_patterns("__pycache__", ".*_cache"))
        (copy / part / f"{SECRET}.txt").write_text(SECRET, encoding="utf-8")
    open_to_all(copy)
    return copy


@pytest.fixture(scope="session")
def store(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Shared by all workers of a run, as in a class: what others build is not looked at."""
    folder = tmp_path_factory.getbasetemp().parent / "hostile-builds"
    folder.mkdir(exist_ok=True)
    return folder


@pytest.fixture
def worlds() -> list[World]:
    """All worlds of the test, the newest last."""
    return []


@pytest.fixture(autouse=True)
def untouched(worlds: list[World]) -> Iterator[None]:
    """The proof once more after a test, because what a submission left behind may act late."""
    yield
    for world in worlds:
        if world.seen:
            world.prove()
        shutil.rmtree(world.home.parent)


@pytest.fixture
def grade(
    open_place: Path, course_copy: Path, store: Path, tmp_path: Path, worlds: list[World], untouched: None
) -> Grade:
    """`grade(files, exercise="18-publisher", guarantee="...", local=True)`; see `world`."""

    def in_new_world(
        files: Mapping[str, str | bytes],
        exercise: str = "18-publisher",
        *,
        guarantee: str,
        local: bool = True,
    ) -> Graded:
        folder = Path(tempfile.mkdtemp(dir=open_place))
        worlds.append(lay_world(folder, course_copy, store, exercise, files))
        evidence = tmp_path / f"evidence-{len(worlds)}" / "evidence.mcap"
        return graded(worlds[-1], exercise, evidence, guarantee=guarantee, local=local)

    return in_new_world


@pytest.fixture
def machine() -> Iterator[Lateness]:
    """How busy this machine is meanwhile with anything except these tests."""
    with measured_lateness(Timeline()) as measured:
        yield measured
