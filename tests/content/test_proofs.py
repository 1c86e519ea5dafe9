"""Mistakes and alternatives, as graders' tests get them."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.content import Edit, Mistake, open_course, shared_files
from course.errors import ContentError

PACKAGE = "ros2_tutorial_workspace/src/lanterns/lanterns"


def test_a_mistake_is_read_whole(small_course: Path) -> None:
    assert open_course(small_course).exercise("04-light").mistakes() == (
        Mistake(
            id="too-dark",
            exercise="04-light",
            summary="The lantern is hardly lit.",
            edits=(Edit(f"{PACKAGE}/light.py", replace="return 100", with_="return 10"),),
            caught_by="is_bright",
            says=("10", "100"),
        ),
    )


def test_each_kind_of_edit_is_read(small_course: Path) -> None:
    no_dimmer, misspelt = open_course(small_course).exercise("04-dim").mistakes()
    assert no_dimmer.edits == (Edit(f"{PACKAGE}/dim.py", delete=True),)
    assert misspelt.edits == (
        Edit(f"{PACKAGE}/dim.py", rename=f"{PACKAGE}/dimm.py"),
        Edit(f"{PACKAGE}/names.py", content='NAME = "dimm"\n'),
        Edit(f"{PACKAGE}/light.py", mode="755"),
    )


def test_a_chapter_may_have_no_mistakes(small_course: Path) -> None:
    (small_course / "chapters/04-lanterns/mistakes.yaml").unlink()
    assert open_course(small_course).exercise("04-dim").mistakes() == ()


def test_alternatives_are_those_of_the_exercise(small_course: Path) -> None:
    course = open_course(small_course)
    (other,) = course.exercise("04-dim").alternatives()
    assert (other.name, other.summary) == ("shifts-bits", "Shifts the bits.")
    assert other.deletes == (f"{PACKAGE}/names.py",)
    assert (other.tree / PACKAGE / "dim.py").is_file()
    assert course.exercise("04-light").alternatives() == ()


def test_an_alternative_must_say_what_it_is(small_course: Path) -> None:
    exercise = open_course(small_course).exercise("04-dim")
    (exercise.alternatives()[0].tree / "alternative.yaml").unlink()
    with pytest.raises(ContentError, match="the file is missing"):
        exercise.alternatives()


def test_shared_files_are_those_of_several_exercises(small_course: Path) -> None:
    dim = open_course(small_course).exercise("04-dim")
    assert shared_files(dim) == {f"{PACKAGE}/names.py"}
