"""Which names an author may use, and what follows from them."""

from __future__ import annotations

import pytest

from course.authoring.course_folder import number_and_slug
from course.authoring.exercise import ExerciseName
from course.errors import UsageError


@pytest.mark.parametrize(
    ("name", "number", "found"),
    [
        ("30-battery", None, (30, "battery")),
        ("battery", 7, (7, "battery")),
        ("30-battery", 7, (30, "battery")),
        ("a-2-b", 7, (7, "a-2-b")),
    ],
)
def test_number_and_slug(name: str, number: int | None, found: tuple[int, str]) -> None:
    assert number_and_slug(name, number) == found


@pytest.mark.parametrize(
    "name",
    ["", "30-", "30-Battery", "battery_level", "a--b", "-a", "3-a", "30-2nd", "../a", "a b", "a\n", "häufig"],
)
def test_no_names(name: str) -> None:
    with pytest.raises(UsageError, match="is not a name") as caught:
        number_and_slug(name)
    assert caught.value.next_step and "30-battery" in caught.value.next_step


def test_too_long() -> None:
    with pytest.raises(UsageError, match="too long"):
        number_and_slug("a" * 41)


def test_what_follows_from_it() -> None:
    name = ExerciseName(3, "class-2-go")
    assert (name.id, name.title, name.package) == ("03-class-2-go", "Class 2 go", "class_2_go_package")
    assert (name.node, name.node_class) == ("class_2_go_node", "Class2GoNode")
