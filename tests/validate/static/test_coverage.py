"""Mistakes name checks that exist, apply to the end, and leave no check out."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from .conftest import GRADER, Change, Tell

MISTAKES = "chapters/04-lanterns/mistakes.yaml"
NAME = "graders/ch04_lanterns.py"
FIXTURES = Path(__file__).parents[2] / "fixtures"


def test_a_check_that_no_mistake_fails(change: Change, tell: Tell) -> None:
    more = '\n\n@dim.check("warm", "it is warm")\ndef warm(recording: Recording) -> None:\n    fail("cold")\n'
    change(NAME, "", GRADER + more)
    assert tell() == [f"{NAME}:25: no mistake fails check `warm` of 04-dim"]


def test_the_check_that_comes_by_itself(change: Change, tell: Tell) -> None:
    change(NAME, 'Grader("04-dim", builds=None)', 'Grader("04-dim")')
    assert tell() == [f"{NAME}:7: no mistake fails check `builds` of 04-dim"]


def test_a_check_that_can_only_be_not_applicable_needs_no_mistake(change: Change, tell: Tell) -> None:
    more = (
        '\n\n@dim.check("extra", "extra")\ndef extra(r: Recording) -> None:\n    raise NotApplicable("x")\n'
    )
    change(NAME, "", GRADER + more)
    assert tell() == []


def test_mistakes_that_name_no_check(change: Change, tell: Tell) -> None:
    change(MISTAKES, "caught_by: is_bright", "caught_by: is_brigth\n    also_fails: [glows]")
    assert tell() == [
        f"{MISTAKES}:9: `too-dark`: 04-light has no check `is_brigth`; did you mean `is_bright`?",
        f"{MISTAKES}:10: `too-dark`: 04-light has no check `glows`",
        f"{NAME}:10: no mistake fails check `is_bright` of 04-light",
    ]


@pytest.mark.parametrize(
    ("edit", "what"),
    [
        ("replace: return 100\n        with: x", "this text does not occur in"),
        ("delete: true", None),
        ("replace: return 10\n        with: return 1", None),
    ],
)
def test_a_later_edit_of_a_file(edit: str, what: str | None, change: Change, tell: Tell) -> None:
    file = "ros2_tutorial_workspace/src/lanterns/lanterns/light.py"
    change(MISTAKES, "with: return 10\n", f"with: return 10\n      - file: {file}\n        {edit}\n")
    told = tell()
    assert [line.split(file)[0] for line in told] == ([f"{MISTAKES}:10: {what} "] if what else [])


def test_an_edit_of_a_file_that_is_gone(change: Change, tell: Tell) -> None:
    file = "ros2_tutorial_workspace/src/lanterns/lanterns/dim.py"
    change(MISTAKES, "delete: true\n", f"delete: true\n      - file: {file}\n        mode: '755'\n")
    assert tell() == [f"{MISTAKES}:17: an earlier edit removed or renamed `{file}` (mistakes[1].edits[1])"]


@pytest.fixture
def quiz_course(tmp_path: Path) -> Path:
    return shutil.copytree(FIXTURES / "quiz_course", tmp_path / "quiz_course")


def test_questions_are_checks_too(quiz_course: Path, tell: Tell) -> None:
    told = tell(folder=quiz_course)
    assert "chapters/05-lighthouses/lesson.yaml:72: no mistake fails check `type` of 05-keepers" in told
    assert not [line for line in told if "05-quiz" in line or "`rate`" in line or "`greeted`" in line]


def test_answers_to_questions_that_nobody_asks(quiz_course: Path, tell: Tell) -> None:
    mistakes = quiz_course / "chapters/05-lighthouses/mistakes.yaml"
    mistakes.write_text(mistakes.read_text().replace("answers: {why:", "answers: {whi:"))
    other = quiz_course / "solutions/05-lighthouses/alternatives/other-words/alternative.yaml"
    other.write_text(other.read_text().replace("period:", "perriod:"))
    told = tell(folder=quiz_course)
    place = "chapters/05-lighthouses/mistakes.yaml"
    assert f"{place}:7: `saves-oil`: 05-quiz has no question `whi`; did you mean `why`?" in told
    assert any("`other-words` answers `perriod`, which none of its exercises asks" in line for line in told)


def test_a_mystery_without_its_answers(quiz_course: Path, tell: Tell) -> None:
    grader = quiz_course / "graders/ch05_lighthouses.py"
    grader.write_text(grader.read_text().replace('Mystery("05-keepers"', 'Mystery("05-keeper"'))
    told = tell(folder=quiz_course)
    assert any("ch05_lighthouses.py has no `Mystery` of 05-keepers" in line for line in told)
    assert any("`Mystery` of `05-keeper`, which its chapter does not have" in line for line in told)
