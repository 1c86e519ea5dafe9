"""Any file of a course may hold anything, or be something else: it is told of, never a traceback."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from course.errors import CourseError

from .conftest import Tell

pytestmark = pytest.mark.slow

FIXTURES = Path(__file__).parents[2] / "fixtures"
FILES = [
    file.relative_to(FIXTURES)
    for name in ("small_course", "quiz_course")
    for file in sorted((FIXTURES / name).rglob("*"))
    if file.is_file() and "__pycache__" not in file.parts
]


def binary(file: Path) -> None:
    file.write_bytes(bytes(range(256)) * 8)


def empty(file: Path) -> None:
    file.write_text("")


def nested(file: Path) -> None:
    file.write_text("[" * 300 + "\n" + "> " * 300 + "`ros2 x")


def a_list(file: Path) -> None:
    file.write_text("- exercises: &a [*a]\n- 7\n")


def folder(file: Path) -> None:
    file.unlink()
    file.mkdir()


def loop(file: Path) -> None:
    file.unlink()
    file.symlink_to(file)


@pytest.mark.parametrize("spoil", [binary, empty, nested, a_list, folder, loop])
def test_any_file(spoil: Callable[[Path], None], tmp_path: Path, tell: Tell) -> None:
    for number, file in enumerate(FILES):
        copy = shutil.copytree(FIXTURES / file.parts[0], tmp_path / str(number), symlinks=True)
        spoil(copy.joinpath(*file.parts[1:]))
        try:
            tell(folder=copy)
        except CourseError as error:
            assert error.what, file
