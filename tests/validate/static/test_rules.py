"""All errors are reported at once, with those of the course's own audit, and never as a traceback."""

from __future__ import annotations

import contextlib
import os
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from course.cli.validate import complaint
from course.content import open_course
from course.errors import CourseError, StorageError, UsageError
from course.validate.static.rules import findings

from .conftest import Change, Tell

NOBODY = 65534
LESSON = "chapters/04-lanterns/lesson.yaml"
MISTAKES = "chapters/04-lanterns/mistakes.yaml"


def test_the_small_course_is_right(tell: Tell) -> None:
    assert tell() == []


def test_all_is_told_at_once(change: Change, tell: Tell) -> None:
    change(LESSON, "      - Half of it is left.\n", "")
    change("graders/ch05_moons.py", "", "")
    (line, stray) = tell()
    what = "`exercises[1].hints` must contain at least 3 hints, not 2 (exercises[1].hints)"
    assert line == f"{LESSON}:28: {what}"
    assert stray.startswith("graders/ch05_moons.py:None: no chapter has a grader called `ch05_moons.py`")


def test_a_finding_has_its_next_step(change: Change, root: Path) -> None:
    change("graders/ch05_moons.py", "", "")
    (finding,) = findings(open_course(root), open_course(root).exercises())
    assert finding.file == root / "graders/ch05_moons.py"
    assert finding.next_step == "name it after its chapter: `ch18_name.py` for `18-name`"


def test_of_one_exercise_only_what_is_about_it(change: Change, tell: Tell) -> None:
    change("chapters/04-lanterns/04-light.md", "Write", "Look at `77-moon`. Write")
    change("chapters/04-lanterns/04-dim.md", "Write", "Look at `88-sun`. Write")
    change("solutions/09-other/x.py", "", "")
    assert tell("04-dim") == ["chapters/04-lanterns/04-dim.md:1: there is no exercise `88-sun`"]
    assert len(tell()) == 3


def test_a_broken_chapter_is_told_with_all_the_others(root: Path, change: Change, tell: Tell) -> None:
    change(LESSON, "chapter: 4", "chapter: four")
    assert [line for line in tell() if "`chapter` must be a whole number" in line]


@pytest.mark.parametrize("name", [LESSON, MISTAKES])
@pytest.mark.parametrize(
    ("rubbish", "what"),
    [
        (b"\x00\x01\xff\xfe", "this is not UTF-8 text"),
        (b"- a list\n", "must be a mapping of keys to values, not a list"),
        (b"a: [", "this is not valid YAML"),
        (b"", "must be a mapping of keys to values, not empty"),
        (b"7", "must be a mapping of keys to values"),
    ],
)
def test_rubbish_for_yaml(name: str, rubbish: bytes, what: str, root: Path, tell: Tell) -> None:
    (root / name).write_bytes(rubbish)
    first = next(line for line in tell() if line.startswith(f"{name}:"))
    assert what in first


@pytest.mark.parametrize("name", ["lesson.md", "04-dim.md"])
def test_a_text_that_is_none(name: str, root: Path, tell: Tell) -> None:
    file = root / "chapters/04-lanterns" / name
    file.write_bytes(b"Gr\xfc\xdfe")
    assert any(
        line.startswith(f"chapters/04-lanterns/{name}:None: this is not UTF-8 text") for line in tell()
    )
    file.unlink()
    file.mkdir()
    assert any("cannot be read: Is a directory" in line for line in tell())


def test_solutions_and_starters_of_any_bytes(root: Path, tell: Tell) -> None:
    for file in (root / "solutions").rglob("*.py"):
        file.write_bytes(b"\xff\x00")
    for file in (root / "chapters/04-lanterns/starter").rglob("*.py"):
        file.write_bytes(b"\xff\x00")
    file = "ros2_tutorial_workspace/src/lanterns/lanterns/light.py"
    assert tell() == [f"{MISTAKES}:7: this text does not occur in {file} (mistakes[0].edits[0].replace)"]


def test_a_solution_that_is_missing(root: Path, tell: Tell) -> None:
    shutil.rmtree(root / "solutions")
    assert len([line for line in tell() if "is not in the reference solution" in line]) >= 5


def test_no_course_at_all(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="is not a course"):
        open_course(tmp_path / "nothing")


def test_one_id_in_two_chapters(root: Path, tell: Tell) -> None:
    shutil.copytree(root / "chapters/04-lanterns", root / "chapters/04-lamps")
    told = tell()
    what = "`04-light` is an exercise of 04-lamps too, on line 5 of its lesson.yaml"
    assert f"chapters/04-lanterns/lesson.yaml:5: {what}" in told
    assert any("have the same number" in line for line in told)


def test_a_circle_of_requirements(change: Change, tell: Tell) -> None:
    change(LESSON, "    title: Light it\n", "    title: Light it\n    requires: [04-dim]\n")
    assert tell() == [f"{LESSON}:24: `04-dim` requires itself: 04-dim -> 04-light -> 04-dim"
                      " (exercises[1].requires[0])"]  # fmt: skip


def test_folders_that_cannot_be_read(root: Path, open_folder: Path, tell: Tell) -> None:
    course = shutil.copytree(root, open_folder / "course")
    assert tell(folder=course) == []  # with it, all is imported that an unprivileged user cannot
    with (
        unreadable(course / "solutions"),
        pytest.raises(StorageError, match="cannot be read: Permission denied"),
    ):
        tell(folder=course)


@contextlib.contextmanager
def unreadable(folder: Path) -> Iterator[None]:
    """For root, too."""
    was_root = os.geteuid() == 0
    folder.chmod(0)
    if was_root:
        os.seteuid(NOBODY)
    try:
        yield
    finally:
        if was_root:
            os.seteuid(0)
        folder.chmod(0o755)


@pytest.mark.slow
def test_nothing_is_wrong_with_it() -> None:
    course = open_course()
    assert findings(course, course.exercises(), complaint) == []


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


@pytest.mark.slow
@pytest.mark.parametrize("spoil", [binary, empty, nested, a_list, folder, loop])
def test_any_file(spoil: Callable[[Path], None], tmp_path: Path, tell: Tell) -> None:
    for number, file in enumerate(FILES):
        copy = shutil.copytree(FIXTURES / file.parts[0], tmp_path / str(number), symlinks=True)
        spoil(copy.joinpath(*file.parts[1:]))
        try:
            tell(folder=copy)
        except CourseError as error:
            assert error.what, file
