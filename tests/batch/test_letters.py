"""Letters for a class of twenty-four, for Canvas and for Moodle."""

from __future__ import annotations

import json
import zipfile
from pathlib import Path

import pytest

from course.cli.main import main
from tests.batch.samples import QUIZ
from tests.batch.term import ABSENT, COURSE, FIRST, identity, lay_moodle, lay_term, name

EVERYBODY = {identity(place) for place in range(len(FIRST))}
THERE = EVERYBODY - {identity(place) for place in ABSENT}


def ros2course(*words: str) -> int:
    return main(["--course", str(COURSE), *words])


def grade(submissions: Path, out: Path, *words: str) -> Path:
    assert ros2course("grade", str(submissions), "--exercises", QUIZ, "--out", str(out), *words) == 0
    return out


@pytest.fixture(scope="module")
def term(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return lay_moodle(lay_term(tmp_path_factory.mktemp("letters") / "term"))


def participants(file: Path) -> dict[str, str]:
    """The owner of each letter, by Moodle's own rule: the second of five parts between underscores."""
    with zipfile.ZipFile(file) as archive:
        parts = {each: each.split("_", 4) for each in archive.namelist()}
        kinds = {tuple(one[2:]) for one in parts.values()}
        assert kinds == {("assignfeedback", "file", "feedback.md")}
        assert not any("/" in each for each in parts)
        return {one[1]: archive.read(each).decode() for each, one in parts.items()}


def roster(term: Path, head: str, rows: list[str]) -> tuple[str, str]:
    file = term / "roster.csv"
    file.write_text("\n".join([head, *rows]), encoding="utf-8")
    return "--roster", str(file)


def test_canvas_has_a_comment_for_everybody(
    term: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = grade(term / "class.zip", tmp_path / "out", "--roster", str(term / "canvas.csv"))
    capsys.readouterr()
    assert ros2course("results", "canvas", str(out)) == 0
    assert "24 comments" in capsys.readouterr().out
    sent = json.loads((out / "canvas-comments.json").read_text(encoding="utf-8"))["grade_data"]
    assert set(sent) == EVERYBODY
    for who, data in sent.items():
        assert data == {"text_comment": (out / f"feedback/{who}.md").read_text(encoding="utf-8")}
    assert ros2course("results", "moodle", str(out)) == 2
    assert "a Moodle number" in capsys.readouterr().err


def test_student_numbers_are_not_taken_for_moodle_s(
    term: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A list with school ids does not contain Moodle's ids of those who handed in nothing."""
    rows = [f'"{name(place)}",{5200 - place}' for place in range(len(FIRST))]
    out = grade(term / "moodle", tmp_path / "out", *roster(term, "Full name,ID number", rows))
    capsys.readouterr()
    assert ros2course("results", "moodle", str(out)) == 0
    letters = participants(out / "moodle-feedback.zip")
    assert set(letters) == THERE
    assert all(text.startswith(f"# Feedback for {name(int(who) - 4100)}") for who, text in letters.items())
    said = capsys.readouterr().out
    assert said.count("left out") == len(ABSENT) and "22 letters" in said


def test_of_a_group_each_gets_their_own_letter(term: Path, tmp_path: Path) -> None:
    rows = [f'"{name(place)}",{identity(place)},G{place // 2}' for place in range(len(FIRST))]
    out = grade(term / "moodle", tmp_path / "out", *roster(term, "name,id,group", rows))
    assert ros2course("results", "moodle", str(out)) == 0
    letters = participants(out / "moodle-feedback.zip")
    assert set(letters) == EVERYBODY
    assert all(text.startswith(f"# Feedback for {name(int(who) - 4100)}") for who, text in letters.items())
