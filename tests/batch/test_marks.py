"""marks.yaml: what people decided, and which mistakes in it are reported."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.batch.marks import Decisions, read_decisions
from course.errors import UsageError
from course.model.gradebook import HandMark, Person

PEOPLE = (Person("007", "Ada Okafor"), Person("bao", "Bao"), Person("cy", "Same"), Person("cyd", "Same"))
CHECKS = {"05-quiz": ("why", "seen"), "04-light": ("shines",)}


def read(folder: Path, text: str) -> Decisions:
    (folder / "marks.yaml").write_text(text, encoding="utf-8")
    return read_decisions(folder, PEOPLE, CHECKS)


def test_every_kind_of_decision(tmp_path: Path) -> None:
    text = """
rubric:
  names: {bonus: -1, comment: Name variables by what they hold.}
marks:
  - {person: 007, exercise: 05-quiz, check: why, points: 1.5, comment: Nearly.}
  - {person: Ada Okafor, exercise: 05-quiz, rubric: names}
  - {person: [bao, Ada Okafor], bonus: 2}
  - {person: cy, excused: yes}
  - {person: cyd, exercise: 04-light, points: , bonus: , comment: }
"""
    assert read(tmp_path, text).marks == {
        "007": (
            HandMark("05-quiz", "why", 1.5, comment="Nearly."),
            HandMark("05-quiz", bonus=-1, comment="Name variables by what they hold."),
            HandMark(bonus=2),
        ),
        "bao": (HandMark(bonus=2),),
        "cy": (HandMark(excused=True),),
        "cyd": (),
    }


def test_lateness_by_hand(tmp_path: Path) -> None:
    (tmp_path / "deadlines.yaml").write_text("due: 2026-10-05 23:59\n")
    text = "marks:\n  - {person: bao, late: 2 days}\n  - {person: cy, late: no}\n"
    assert read(tmp_path, text).late_by == {"bao": 172_800, "cy": 0}


def test_no_files_are_no_decisions(tmp_path: Path) -> None:
    assert read_decisions(tmp_path, PEOPLE, CHECKS) == Decisions()


@pytest.mark.parametrize(
    ("entry", "said"),
    [
        ("person: baoo", "nobody in this class is called `baoo`; did you mean `bao`"),
        ("person: [cy, bao, baoo]", "nobody in this class is called `baoo`; did you mean `bao`"),
        ("person: Same", "nobody in this class is called `Same`"),
        ("person: '7'", "nobody in this class is called `7`"),
        ("bonus: 1", "`person` is missing"),
        ("person: bao, exercise: 05-quizz, points: 1", "no exercise `05-quizz`; did you mean `05-quiz`"),
        ("person: bao, exercise: 05-quiz, check: whi, points: 1", "no check `whi`; did you mean `why`"),
        ("person: bao, check: why, points: 1", "no check `why`"),
        ("person: bao, points: 1", "none is named"),
        ("person: bao, exercise: 05-quiz, points: -1", "greater than or equal to 0"),
        ("person: bao, exercise: 05-quiz, points: nan", "finite number"),
        ("person: bao, exercise: 05-quiz, points: two", "valid number"),
        ("person: bao, exercise: 05-quiz, check: why, excused: true", "one check cannot be excused"),
        ("person: bao, rubric: [names]", "no rubric item `names`"),
        ("person: bao, late: 2 days", "nothing says what being late costs"),
        ("person: bao, late: tomorrow", "must be a time span"),
        ("person: bao, bonnus: 1", "did you mean `bonus`"),
    ],
)
def test_mistakes_are_told_with_their_line(tmp_path: Path, entry: str, said: str) -> None:
    with pytest.raises(UsageError) as raised:
        read(tmp_path, f"marks:\n  - {{person: cy, bonus: 1}}\n  - {{{entry}}}\n")
    assert said in raised.value.what
    assert "marks.yaml:3" in raised.value.what


def test_all_mistakes_are_told_at_once(tmp_path: Path) -> None:
    with pytest.raises(UsageError) as raised:
        read(tmp_path, "marks:\n  - {person: eve}\n  - {person: mallory}\n")
    assert raised.value.what.count("nobody in this class") == 2


@pytest.mark.parametrize("text", ["- 1\n", "marks: [1]\n", "marks: {\n", "marks: &a [*a]\n", "\xff"])
def test_what_is_no_such_file(tmp_path: Path, text: str) -> None:
    (tmp_path / "marks.yaml").write_bytes(text.encode("latin-1"))
    with pytest.raises(UsageError, match=r"marks\.yaml"):
        read_decisions(tmp_path, PEOPLE, CHECKS)
