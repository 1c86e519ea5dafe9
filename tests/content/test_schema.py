"""Wrong lesson and mistake files: each error names file, line, key, what is allowed, the nearest name."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.content import open_course
from course.errors import ContentError

Edit = Callable[[str, str], Path]


def error_of(small_course: Path) -> ContentError:
    with pytest.raises(ContentError) as caught:
        open_course(small_course).chapters()
    return caught.value


@pytest.mark.parametrize(
    ("old", "new", "line", "key", "what", "allowed"),
    [
        ("title: Lanterns\n", "", 1, "title", "`title` is missing", "add `title`: one line"),
        (
            "title: Lanterns",
            "titel: Lanterns",
            2,
            "titel",
            "did you mean `title`?",
            "chapter, title, summary",
        ),
        ("chapter: 4", "chapter: four", 1, "chapter", "must be a whole number, not a text", "number"),
        ("chapter: 4", "chapter: '4'", 1, "chapter", "must be a whole number, not a text", "number"),
        ("chapter: 4", "chapter: 5", 1, "chapter", "but the folder is `04-lanterns`", "allowed: 4"),
        ("title: Lanterns", "title: 12", 2, "title", "must be a text, not `12` (put it in quotes", "line"),
        ("title: Lanterns", "title: yes", 2, "title", "must be a text, not `true` (put it in qu", "line"),
        ("title: Lanterns", "title:", 2, "title", "must be a text, not empty", "one line"),
        ("title: Lanterns", "title: ' '", 2, "title", "must not be empty", "one line"),
        ("title: Lanterns", 'title: "a\\nb"', 2, "title", "must be a single line", "one line"),
        ("id: 04-light", "id: 05-light", 5, "exercises[0].id", "must begin with `04-`", "`04-` and"),
        ("id: 04-light", "id: light", 5, "exercises[0].id", "must look like `18-publisher`", "two digits"),
        ("id: 04-light", "id: 04-Light", 5, "exercises[0].id", "must look like", "two digits"),
        ("id: 04-light", "id: 04-dim", 18, "exercises[1].id", "used twice; the first is in line 5", "own"),
        ("    title: Light it\n", "", 5, "exercises[0].title", "`title` is missing", "add `title`: one"),
        ("[lanterns]", "lanterns", 8, "exercises[0].packages", "must be a list, not a text", "ROS packages"),
        ("[lanterns]", "[Lan terns]", 8, "exercises[0].packages[0]", "must be the name of a ROS", "a list"),
        ("ros2_tut", "/ros2_tut", 10, "exercises[0].files[0]", "must be a file inside the", "relative to"),
        ("ros2_tut", "../ros2_tut", 10, "exercises[0].files[0]", "must be a file inside", "relative to"),
        ("ros2_tut", "./ros2_tut", 10, "exercises[0].files[0]", "must be written `ros2_tut", "relative to"),
        ("time_limit: 20", "time_limit: 0", 27, "exercises[1].time_limit", "must be more than 0", "seconds"),
        ("time_limit: 20", "time_limit: .nan", 27, "exercises[1].time_limit", "more than 0", "seconds"),
        ("time_limit: 20", "time_limit: soon", 27, "exercises[1].time_limit", "must be a number", "60"),
        ("time_limit:", "timelimit:", 27, "exercises[1].timelimit", "did you mean `time_limit`?", "hints"),
        (
            "      - Half of it is left.\n",
            "",
            28,
            "exercises[1].hints",
            "at least 3 hints, not 2",
            "Markdown",
        ),
        ("- Half of it is left.", "- ''", 29, "exercises[1].hints[0]", "must not be empty", "Markdown"),
        ("- Half of it", "- Half: of it", 29, "exercises[1].hints[0]", "not a mapping (put it in", "Markd"),
        (
            "    after:",
            "    hints: []\n    after:",
            17,
            "hints",
            "twice here; the first is in line 13",
            "one",
        ),
        ("exercises:\n", "exercises: none\nx:\n", 4, "exercises", "must be a list, not a text", "exercises"),
    ],
)
def test_a_wrong_lesson(
    small_course: Path, lesson: Edit, old: str, new: str, line: int, key: str, what: str, allowed: str
) -> None:
    file = lesson(old, new)
    error = error_of(small_course)
    assert (error.file, error.line, error.key) == (file, line, key)
    assert what in error.what
    assert allowed in (error.next_step or "")


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
    ("old", "new", "line", "key", "what"),
    [
        ("with: return 10", "wiht: return 10", 8, "mistakes[0].edits[0].wiht", "did you mean `with`?"),
        ("        with: return 10\n", "", 6, "mistakes[0].edits[0]", "`replace` and `with` together"),
        ("delete: true", "delete: false", 15, "mistakes[1].edits[0]", "exactly one of replace, delete"),
        ("delete: true", "delete: 'yes'", 16, "mistakes[1].edits[0].delete", "must be `true` or `false`"),
        ('mode: "755"', "mode: 755", 29, "mistakes[2].edits[2].mode", "not `755` (put it in quotes"),
        ('mode: "755"', "mode: rwx", 29, "mistakes[2].edits[2].mode", "an octal mode in quotes"),
        (
            "caught_by: is_bright",
            "caugth_by: is_bright",
            9,
            "mistakes[0].caugth_by",
            "mean `caught_by`?",
        ),
        ("    caught_by: is_bright\n", "", 2, "mistakes[0].caught_by", "is missing"),
        ("says: [dim.py]", "says: []", 18, "mistakes[1].says", "must not be an empty list"),
        ("id: no-dimmer", "id: too-dark", 11, "mistakes[1].id", "used twice; the first is in line 2"),
        ("mistakes:", "errors:", 1, "mistakes", "`mistakes` is missing"),
    ],
)
def test_a_wrong_mistake(
    small_course: Path, mistakes: Edit, old: str, new: str, line: int, key: str, what: str
) -> None:
    file = mistakes(old, new)
    with pytest.raises(ContentError) as caught:
        open_course(small_course).exercise("04-dim").mistakes()
    assert caught.value.file == file
    assert (caught.value.line, caught.value.key) == (line, key)
    assert what in caught.value.what
