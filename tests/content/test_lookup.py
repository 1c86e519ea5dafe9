"""What a learner may type for an exercise's id."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.content import open_course
from course.content.lookup import choose, tidy, unknown
from course.errors import ContentError, UsageError

IDS = (
    "02-script",
    "18-publisher",
    "18-subscriber",
    "19-inspect-topics",
    "20-server",
    "20-client",
    "21-publish",
    "30-server",
)


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("18-publisher", "18-publisher"),
        ("18-pub", "18-publisher"),
        ("subscriber", "18-subscriber"),
        ("19", "19-inspect-topics"),
        ("2", "02-script"),
        ("2-script", "02-script"),
        ("02-s", "02-script"),
        ("inspect", "19-inspect-topics"),
        ("client", "20-client"),
        ("publisher", "18-publisher"),
        ("publish", "21-publish"),  # a whole name, though another one begins with it
        (" 18_Publisher ", "18-publisher"),
    ],
)
def test_an_abbreviation_that_fits_one_works(typed: str, meant: str) -> None:
    assert choose(tidy(typed), IDS) == meant


@pytest.mark.parametrize(
    ("typed", "listed"),
    [
        ("18", "18-publisher, 18-subscriber"),
        ("server", "20-server, 30-server"),
        ("publ", "18-publisher, 21-publish"),
    ],
)
def test_one_that_fits_several_names_them(typed: str, listed: str) -> None:
    with pytest.raises(UsageError, match="fits several") as caught:
        choose(typed, IDS)
    assert caught.value.next_step is not None
    assert caught.value.next_step.endswith(listed)


@pytest.mark.parametrize("typed", ["99", "18-x", "", "ublisher", "1"])
def test_what_fits_nothing_is_nothing(typed: str) -> None:
    assert choose(typed, IDS) is None


@pytest.mark.parametrize(
    ("typed", "meant"),
    [("18-pubisher", "18-publisher"), ("pubisher", "18-publisher"), ("19-server", "20-server")],
)
def test_an_unknown_one_gets_the_nearest(typed: str, meant: str) -> None:
    error = unknown(typed, IDS)
    assert error.what == f"there is no exercise `{typed}`"
    assert meant in (error.next_step or "")


def test_one_unlike_all_gets_the_list() -> None:
    assert unknown("zzz", IDS).next_step == "`ros2course list` shows them all"


def test_only_the_chapter_that_is_named_is_read(small_course: Path) -> None:
    broken = small_course / "chapters/05-broken"
    broken.mkdir()
    (broken / "lesson.yaml").write_text("nonsense: [")
    course = open_course(small_course)
    assert course.exercise("04-dim").id == "04-dim"
    assert course.exercise("light").id == "04-light"
    with pytest.raises(UsageError, match="no exercise `04-dum`"):
        course.exercise("04-dum")
    with pytest.raises(ContentError):
        course.exercise("05-any")
