"""A cached lesson is used only while it matches the file."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from course.content import open_course
from course.content.chapter import LessonCache
from course.errors import ContentError

Edit = Callable[[str, str], Path]


@pytest.fixture
def cache(tmp_path: Path) -> Path:
    return tmp_path / "cache"


def kept(cache: Path) -> Path:
    (file,) = cache.iterdir()
    return file


def test_the_same_exercises_come_out(small_course: Path, cache: Path) -> None:
    plain = open_course(small_course).exercises()
    assert open_course(small_course, cache=cache).exercises() == plain
    assert open_course(small_course, cache=cache).exercises() == plain


def test_the_second_time_it_is_not_read(small_course: Path, cache: Path) -> None:
    open_course(small_course, cache=cache).exercises()

    def never() -> dict[str, object]:
        raise AssertionError("read again")

    lesson = LessonCache(cache).get(small_course / "chapters/04-lanterns", never)
    assert lesson["title"] == "Lanterns"


def test_a_changed_lesson_is_read_anew(small_course: Path, cache: Path, lesson: Edit) -> None:
    open_course(small_course, cache=cache).chapters()
    lesson("title: Lanterns", "title: Beacons!")  # as long as before
    assert open_course(small_course, cache=cache).chapters()[0].title == "Beacons!"
    assert kept(cache)  # still one file: edits do not make the cache grow


def test_a_lesson_that_became_wrong_is_an_error(small_course: Path, cache: Path, lesson: Edit) -> None:
    open_course(small_course, cache=cache).chapters()
    lesson("title: Lanterns", "titel: Lanterns")
    with pytest.raises(ContentError):
        open_course(small_course, cache=cache).chapters()


def test_other_rules_mean_reading_anew(
    small_course: Path, cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    open_course(small_course, cache=cache).chapters()
    before = kept(cache).read_text()
    monkeypatch.setattr("course.content.chapter._RULES", ("schema.py",))
    open_course(small_course, cache=cache).chapters()
    assert kept(cache).read_text() != before


@pytest.mark.parametrize("content", ["", "{", "[]", "{}", '{"proof": 1, "lesson": 2}'])
def test_a_damaged_cache_is_no_matter(small_course: Path, cache: Path, content: str) -> None:
    open_course(small_course, cache=cache).chapters()
    kept(cache).write_text(content)
    assert open_course(small_course, cache=cache).chapters()[0].title == "Lanterns"
    assert json.loads(kept(cache).read_text())["lesson"]["title"] == "Lanterns"


def test_a_cache_that_cannot_be_written_is_no_matter(small_course: Path, cache: Path) -> None:
    cache.write_text("a file where the folder should be")
    assert open_course(small_course, cache=cache).chapters()[0].title == "Lanterns"
