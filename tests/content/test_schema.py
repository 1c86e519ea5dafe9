"""Wrong lesson and mistake files: each error names file, line, key, what is allowed, the nearest name."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.content import open_course
from course.errors import ContentError
from tests.golden import golden

Edit = Callable[[str, str], Path]


def refused(act: Callable[[], object]) -> ContentError:
    with pytest.raises(ContentError) as caught:
        act()
    return caught.value


def error_of(small_course: Path) -> ContentError:
    return refused(open_course(small_course).chapters)


def held(error: ContentError, file: Path) -> None:
    assert error.file == file
    golden({"line": error.line, "key": error.key, "what": error.what, "next": error.next_step})


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("title: Lanterns\n", ""),
        ("title: Lanterns", "titel: Lanterns"),
        ("chapter: 4", "chapter: four"),
        ("chapter: 4", "chapter: '4'"),
        ("chapter: 4", "chapter: 5"),
        ("title: Lanterns", "title: 12"),
        ("title: Lanterns", "title: yes"),
        ("title: Lanterns", "title:"),
        ("title: Lanterns", "title: ' '"),
        ("title: Lanterns", 'title: "a\\nb"'),
        ("exercises:", "links: {Nodes: docs.ros.org}\nexercises:"),
        ("id: 04-light", "id: 05-light"),
        ("id: 04-light", "id: light"),
        ("id: 04-light", "id: 04-Light"),
        ("id: 04-light", "id: 04-dim"),
        ("    title: Light it\n", ""),
        ("[lanterns]", "lanterns"),
        ("[lanterns]", "[Lan terns]"),
        ("ros2_tut", "/ros2_tut"),
        ("ros2_tut", "../ros2_tut"),
        ("ros2_tut", "./ros2_tut"),
        ("time_limit: 20", "time_limit: 0"),
        ("time_limit: 20", "time_limit: .nan"),
        ("time_limit: 20", "time_limit: soon"),
        ("time_limit:", "timelimit:"),
        ("      - Half of it is left.\n", ""),
        ("- Half of it is left.", "- ''"),
        ("- Half of it", "- Half: of it"),
        ("    after:", "    hints: []\n    after:"),
        ("exercises:\n", "exercises: none\nx:\n"),
    ],
)
def test_a_wrong_lesson(small_course: Path, lesson: Edit, old: str, new: str) -> None:
    file = lesson(old, new)
    held(error_of(small_course), file)


@pytest.mark.parametrize(
    ("content", "line", "what"),
    [
        (b"chapter: 4\ntitle: [a\nsummary: b\n", 3, "this is not valid YAML"),
        (b"chapter: 4\n\ttitle: a\n", 2, "this is not valid YAML"),
        (b"chapter: 4\ntitle: !!python/name:os.system a\n", 2, "this is not valid YAML"),
        (b"chapter: 4\ntitle: caf\xe9\n", 2, "not UTF-8"),
        (b"chapter: 2026-13-40\n", None, "this is not YAML"),
        (b"chapter: \0\n", None, "this is not YAML"),
        (b"", 1, "the file must be a mapping of keys to values, not empty"),
        (b"- a\n- b\n", 1, "the file must be a mapping of keys to values, not a list"),
        (b"a: &a [*a]\n", 1, "`chapter` is missing"),
    ],
)
def test_a_file_that_is_no_lesson_at_all(
    small_course: Path, content: bytes, line: int | None, what: str
) -> None:
    file = small_course / "chapters/04-lanterns/lesson.yaml"
    file.write_bytes(content)
    error = error_of(small_course)
    assert (error.file, error.line) == (file, line)
    assert what in error.what


def test_a_missing_lesson_file(small_course: Path) -> None:
    file = small_course / "chapters/04-lanterns/lesson.yaml"
    file.unlink()
    assert error_of(small_course).file == file


def test_a_badly_named_folder(small_course: Path) -> None:
    (small_course / "chapters/04-lanterns").rename(small_course / "chapters/4_Lanterns")
    assert "`4_Lanterns` is not named like" in error_of(small_course).what


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("with: return 10", "wiht: return 10"),
        ("        with: return 10\n", ""),
        ("delete: true", "delete: false"),
        ("delete: true", "delete: 'yes'"),
        ('mode: "755"', "mode: 755"),
        ('mode: "755"', "mode: rwx"),
        ("caught_by: is_bright", "caugth_by: is_bright"),
        ("    caught_by: is_bright\n", ""),
        ("says: [dim.py]", "says: []"),
        ("id: no-dimmer", "id: too-dark"),
        ("mistakes:", "errors:"),
    ],
)
def test_a_wrong_mistake(small_course: Path, mistakes: Edit, old: str, new: str) -> None:
    file = mistakes(old, new)
    held(refused(open_course(small_course).exercise("04-dim").mistakes), file)
