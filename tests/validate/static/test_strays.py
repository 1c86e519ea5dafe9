"""Files that nothing uses, wherever they are."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.authoring.write import template_text

from .conftest import Change, Tell

LANTERNS = "ros2_tutorial_workspace/src/lanterns"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "what"),
    [
        ("chapters/notes.txt", "nothing uses `notes.txt`"),
        ("chapters/04-lanterns/quiz.yaml", "nothing uses `quiz.yaml`"),
        ("chapters/04-lanterns/pictures/lamp.png", "nothing uses `lamp.png`"),
        ("solutions/old.py", "no chapter is called `old.py`"),
        ("solutions/04-lantern/x.py", "no chapter is called `04-lantern`; did you mean `04-lanterns`?"),
        ("graders/ch04_lantern.py", "no chapter has a grader called `ch04_lantern.py`, and no grader uses "
         "it; did you mean `ch04_lanterns.py`?"),
        ("solutions/04-lanterns/alternatives/x.py", "`x.py` belongs to no alternative"),
        ("solutions/04-lanterns/other/x.py", "no exercise uses `other/x.py` of this solution"),
        ("chapters/04-lanterns/starter/04-dim/spare.txt", "no exercise uses `spare.txt` of this starter"),
    ],
)  # fmt: skip
def test_what_nothing_uses(name: str, what: str, change: Change, tell: Tell) -> None:
    change(name, "", "x = 1\n")
    place = "solutions/04-lantern" if "lantern/" in name else name
    assert tell() == [f"{place}:None: {what}"]


@pytest.mark.parametrize(
    "name",
    [
        "chapters/README.md",
        "solutions/README.md",
        "graders/conftest.py",
        "graders/__pycache__/x.pyc",
        f"chapters/04-lanterns/starter/04-dim/{LANTERNS}/more.py",
        f"solutions/04-lanterns/{LANTERNS}/more.py",
        "solutions/04-lanterns/.bashrc",
    ],
)
def test_what_is_used(name: str, change: Change, tell: Tell) -> None:
    change(name, "", "# x\n")
    assert tell() == []


def test_what_is_linked_or_named_is_used(change: Change, tell: Tell) -> None:
    change("chapters/04-lanterns/lamp.png", "", "picture")
    change("chapters/04-lanterns/starter/04-dim/spare.txt", "", "x")
    change("chapters/04-lanterns/04-dim.md", "Write", "![a lamp](lamp.png) Look into `spare.txt`. Write")
    assert tell() == []


def test_what_a_grader_uses(change: Change, tell: Tell) -> None:
    change("graders/lamps.py", "", "x = 1\n")
    change("graders/ch04_lanterns.py", "light = ", 'HELP = "lamps"\nlight = ')
    assert tell() == []


def test_an_alternative_of_no_exercise(root: Path, change: Change, tell: Tell) -> None:
    name = "solutions/04-lanterns/alternatives/shifts-bits/alternative.yaml"
    change(name, "04-dim", "04-dimm")
    assert tell() == [
        f"{name}:1: no exercise of this chapter is called `04-dimm`; did you mean `04-dim`? (exercises[0])"
    ]


TEXT = "chapters/04-lanterns/04-dim.md"


@pytest.mark.parametrize(
    ("link", "what"),
    [
        ("[x](04-ligth.md)", "the link to `04-ligth.md` leads nowhere; did you mean `04-light.md`?"),
        ("![x](lamp.png)", "the link to `lamp.png` leads nowhere"),
        ("[x](lesson.md#lantern)", "lesson.md has no heading `#lantern`; did you mean `lanterns`?"),
        ("[x](#dim-it)", "04-dim.md has no heading `#dim-it`"),
        ("[x][1]\n\n[1]: gone.md", "the link to `gone.md` leads nowhere; did you mean `lesson.md`?"),
    ],
)
def test_links_that_lead_nowhere(link: str, what: str, change: Change, tell: Tell) -> None:
    change(TEXT, "Write", f"First.\n\nSecond,\nsee {link}\n\nWrite")
    assert tell() == [f"{TEXT}:4: {what}"]


@pytest.mark.parametrize(
    "link",
    [
        "[x](lesson.md#lanterns)",
        "[x](./04-light.md)",
        "[x](https://example.com/nothing)",
        "[x](mailto:a@b.invalid)",
        "[x](http://[broken)",
        "`[x](gone.md)`",
        "    [x](gone.md)",
    ],
)
def test_links_that_are_right_or_none(link: str, change: Change, tell: Tell) -> None:
    change(TEXT, "Write", f"First.\n\n{link}\n\nWrite")
    assert tell() == []


def test_links_in_hints(change: Change, tell: Tell) -> None:
    lesson = "chapters/04-lanterns/lesson.yaml"
    change(
        lesson, "      - Half of it is left.", "      - |\n        Half of it.\n\n        See [x](gone.md)."
    )
    assert tell() == [f"{lesson}:32: the link to `gone.md` leads nowhere; did you mean `lesson.md`?"]


def test_a_package_that_the_text_says_is_there_and_that_no_starter_brings(change: Change, tell: Tell) -> None:
    change("chapters/04-lanterns/04-light.md", "", "In it, `lanterns/names.py` is already there.\n")
    (told,) = tell()
    assert told.startswith("chapters/04-lanterns/04-light.md:1: the text says that `names.py` is there")
    change(f"chapters/04-lanterns/starter/04-light/{LANTERNS}/lanterns/names.py", "", "")
    assert not [line for line in tell() if "is there" in line]


def test_sentences_that_new_chapter_wrote_are_found(change: Change, tell: Tell) -> None:
    change("chapters/04-lanterns/lesson.md", "", template_text("chapter/lesson.md"))
    assert [line.split(":")[1] for line in tell() if "`new chapter` wrote" in line] == ["1", "5", "9"]


def test_a_missing_text_is_one_finding(root: Path, tell: Tell) -> None:
    """Its exercise is not known then, so nobody knows what it uses."""
    (root / "chapters/04-lanterns/04-dim.md").unlink()
    assert tell() == ["chapters/04-lanterns/04-dim.md:None: 04-dim.md is missing"]
