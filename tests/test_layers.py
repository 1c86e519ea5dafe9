"""Imports go down only, and a few libraries have one room each."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

REPO = Path(__file__).parents[1]

# Higher rooms import lower ones, never their neighbours.
FLOORS = (
    ("errors", "feedback"),
    ("rosenv", "content"),
    ("build", "arena", "evidence"),
    ("home", "progress", "grading", "report"),
    ("authoring", "batch", "watch"),
    ("validate",),
    ("cli",),
    ("__main__",),
)
FLOOR = {room: height for height, rooms in enumerate(FLOORS) for room in rooms}

# The dataclasses of a verdict are data: everyone may hold one.
RESULT = "course.grading.result"

# Neighbours that one may import after all: what is drawn, and what is stored, are results of grading;
# what happens in the arena goes on the evidence's time line; what a build runs is foreign code, too.
NEIGHBOURS = {("report", "grading"), ("progress", "grading"), ("arena", "evidence"), ("build", "arena")}

# Libraries that only these modules may import: a module itself, or a room with all that is in it.
# Others may name a type of theirs under TYPE_CHECKING.
HOMES = {
    "rclpy": ("course.evidence.recorder", "course.arena.type_probe", "course.arena.player"),
    "rich": ("course.report", "course.watch"),
    "typer": ("course.cli",),
    "jinja2": ("course.report.page",),
    "sqlite3": ("course.progress", "course.batch"),
}


def modules() -> list[Path]:
    return sorted((REPO / "course").rglob("*.py"))


@pytest.mark.parametrize("file", modules(), ids=lambda file: str(file.relative_to(REPO)))
def test_imports_go_down(file: Path) -> None:
    assert list(faults(name_of(file), file.read_text())) == []


@pytest.mark.parametrize(
    ("module", "source", "count"),
    [
        ("course.content.model", "from course.build import build", 1),
        ("course.content.model", "from course.rosenv import find_ros", 1),
        ("course.evidence.recorder", "from course.arena.process import Process", 1),
        ("course.arena.process", "def f():\n    import course.cli.main", 1),
        ("course.build.digest", "from ..grading import check", 1),
        ("course.build.digest", "from course import grading", 1),
        ("course.evidence.recording", "import rclpy.node", 1),
        ("course.cli.check", "from rich.console import Console", 1),
        ("course.cli.check", "if TYPE_CHECKING:\n    import course.__main__", 1),
        ("course.home.init", "import course.nowhere", 1),
        ("course.build.digest", "from course.grading.result import Feedback", 0),
        ("course.build.digest", "from course.grading import result", 0),
        ("course.report.terminal", "import rich\nfrom course.grading import check", 0),
        ("course.evidence.recorder", "import rclpy\nfrom . import events\nfrom course import errors", 0),
        ("course.cli.check", "if TYPE_CHECKING:\n    from rich.console import Console", 0),
        ("course.content.chapter", "from course import __version__\nfrom course.content.names import x", 0),
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
    if here == there or there == "" or within(target, RESULT):
        return True
    if there not in FLOOR or here not in FLOOR:
        return False  # a new room: give it a floor above
    return FLOOR[there] < FLOOR[here] or (here, there) in NEIGHBOURS


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
    """`course.content.model` -> `content`; the package itself has no room."""
    parts = module.split(".")
    return "" if len(parts) < 2 or parts[1] == "__init__" else parts[1]


def within(module: str, outer: str) -> bool:
    return module == outer or module.startswith(f"{outer}.")
