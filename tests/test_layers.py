"""Imports go down only, and a few libraries have one room each."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

REPO = Path(__file__).parents[1]
EXTRAS = REPO / "extras"

# Higher rooms import lower ones, never their neighbors.
FLOORS = (
    ("errors", "spelling", "database"),
    ("model", "files"),
    ("child",),
    ("rosenv", "content"),
    ("isolation",),
    ("evidence",),
    ("explain",),
    ("build", "arena"),
    ("home", "progress", "grading", "report"),
    ("api",),
    ("authoring", "batch", "watch"),
    ("validate",),
    ("cli",),
    ("__main__",),
)
FLOOR = {room: height for height, rooms in enumerate(FLOORS) for room in rooms}

# Neighbors that one may import after all: what is drawn, and what is stored, are results of grading.
NEIGHBORS = {("report", "grading"), ("progress", "grading")}

# Libraries that only these modules may import: a module itself, or a room with all that is in it.
# Others may name a type of theirs under TYPE_CHECKING.
HOMES = {
    "rclpy": ("course.evidence.recorder", "course.arena.mystery_program"),
    "rich": ("course.report", "course.watch"),
    "typer": ("course.cli",),
    "jinja2": ("course.report.page",),
    "sqlite3": ("course.database", "course.progress", "course.batch"),
}


# What the optional tools may import of the engine: whole rooms by their front door, and these modules.
PUBLIC = {
    *("course", "course.errors", "course.content", "course.rosenv"),
    # a command: its options, its course, its output
    *("course.cli.options", "course.cli.usage", "course.cli.session", "course.cli.signals"),
    *("course.report.sanitize", "course.report.console", "course.report.activity", "course.report.activity"),
    *("course.report.validation", "course.report.validation"),
    # submissions, and grading a class
    *("course.home.opening", "course.home.storage", "course.batch.intake", "course.batch.run"),
    *("course.batch.intake.recognize", "course.batch.intake.tree", "course.batch.batch_plan"),
    "course.content.layout",
    *("course.batch.gradings", "course.batch.pool", "course.isolation.levels", "course.files"),
    # proofs, their recordings, and judging these
    *("course.validate", "course.validate.proofs", "course.validate.schedule", "course.validate.proofs"),
    *("course.validate.claims", "course.validate.claims", "course.evidence.mcap_file"),
    *("course.evidence.recording", "course.evidence.topic_view"),
    *("course.model", "course.model.result", "course.model.codec"),
    *("course.grading.judge.plugin", "course.grading.protocol", "course.grading.load"),
    *("course.grading.scenario_digest", "course.grading.trial_answers", "course.grading.judge.judges"),
    "course.child",
    "course.isolation",
}
# The only module of the engine that knows the optional tools.
PLUG_IN = "course.cli.extras"


def modules() -> list[Path]:
    return sorted((REPO / "course").rglob("*.py"))


def extras() -> dict[str, list[Path]]:
    """The files of each optional tool."""
    return {folder.name: sorted(folder.rglob("*.py")) for folder in EXTRAS.iterdir() if folder.is_dir()}


@pytest.mark.parametrize("package", extras())
def test_optional_tools_use_what_is_public(package: str) -> None:
    used = {target for file in extras()[package] for target in _targets_of(file)}
    inside = {target for target in used if target.startswith("course")}
    assert {one for one in inside if not within(one, package) and one not in PUBLIC} == set()


def test_only_the_plug_in_point_names_the_optional_tools() -> None:
    names = re.compile("|".join([*extras(), r"\"course_\{"]))
    assert [name_of(file) for file in modules() if names.search(file.read_text())] == [PLUG_IN]


def test_nothing_public_is_unused() -> None:
    used = {target for files in extras().values() for file in files for target in _targets_of(file)}
    assert used >= PUBLIC


def _targets_of(file: Path) -> set[str]:
    module = ".".join(file.relative_to(EXTRAS).with_suffix("").parts)
    return {target for node in ast.walk(ast.parse(file.read_text())) for target in targets(module, node)}


@pytest.mark.parametrize("file", modules(), ids=lambda file: str(file.relative_to(REPO)))
def test_imports_go_down(file: Path) -> None:
    assert list(faults(name_of(file), file.read_text())) == []


@pytest.mark.parametrize(
    ("module", "source", "count"),
    [
        ("course.content.chapter", "from course.build import build", 1),
        ("course.content.chapter", "from course.rosenv import find_ros", 1),
        ("course.evidence.recorder", "from course.arena.process import Process", 1),
        ("course.arena.process", "def f():\n    import course.cli.main", 1),
        ("course.build.digest", "from ..grading import check", 1),
        ("course.build.digest", "from course import grading", 1),
        ("course.evidence.recording", "import rclpy.node", 1),
        ("course.cli.check", "from rich.console import Console", 1),
        ("course.cli.check", "if TYPE_CHECKING:\n    import course.__main__", 1),
        ("course.home.init", "import course.nowhere", 1),
        ("course.build.digest", "from course.model.result import Feedback", 0),
        ("course.model.result", "from course.build import build", 1),
        ("course.build.digest", "from course.model import result", 0),
        ("course.report.verdict", "import rich\nfrom course.grading import check", 0),
        ("course.evidence.recorder", "import rclpy\nfrom . import events\nfrom course import errors", 0),
        ("course.cli.check", "if TYPE_CHECKING:\n    from rich.console import Console", 0),
        ("course.content.chapter", "from course import __version__\nfrom course.spelling import x", 0),
    ],
)
def test_this_test_sees_faults(module: str, source: str, count: int) -> None:
    assert len(list(faults(module, source))) == count


def faults(module: str, source: str) -> Iterator[str]:
    tree = ast.parse(source)
    only_types = {id(node) for branch in type_checking(tree) for node in ast.walk(branch)}
    for node in ast.walk(tree):
        for target in targets(module, node):
            if not is_allowed(module, target, id(node) in only_types):
                yield f"line {node.lineno}: {module} must not import {target}"


def is_allowed(module: str, target: str, only_type: bool) -> bool:
    if not within(target, "course"):
        homes = HOMES.get(target.split(".")[0])
        return homes is None or only_type or any(within(module, home) for home in homes)
    here, there = room(module), room(target)
    if here == there or there == "":
        return True
    if there not in FLOOR or here not in FLOOR:
        return False  # a new room: give it a floor above
    return FLOOR[there] < FLOOR[here] or (here, there) in NEIGHBORS


def type_checking(tree: ast.AST) -> Iterator[ast.AST]:
    for node in ast.walk(tree):
        if isinstance(node, ast.If) and ast.unparse(node.test).endswith("TYPE_CHECKING"):
            yield from node.body


def targets(module: str, node: ast.AST) -> Iterator[str]:
    if isinstance(node, ast.Import):
        yield from (alias.name for alias in node.names)
    elif isinstance(node, ast.ImportFrom):
        base = absolute(module, node)
        # `from course import content` names a room, `from course.grading import result` a module.
        names = (f"{base}.{alias.name}" for alias in node.names)
        yield from (name if is_module(name) else base for name in names)


def absolute(module: str, node: ast.ImportFrom) -> str:
    if not node.level:
        return node.module or ""
    parents = module.split(".")[: -node.level]
    return ".".join([*parents, *([node.module] if node.module else [])])


def is_module(name: str) -> bool:
    path = REPO.joinpath(*name.split("."))
    return path.is_dir() or path.with_suffix(".py").is_file()


def name_of(file: Path) -> str:
    return ".".join(file.relative_to(REPO).with_suffix("").parts)


def room(module: str) -> str:
    """`course.content.chapter` -> `content`; the package itself has no room."""
    parts = module.split(".")
    return "" if len(parts) < 2 or parts[1] == "__init__" else parts[1]


def within(module: str, outer: str) -> bool:
    return module == outer or module.startswith(f"{outer}.")
