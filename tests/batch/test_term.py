"""A week: a class of twenty-four is graded, marked by people, judged again, and returned to Canvas."""

from __future__ import annotations

import csv
import shutil
from pathlib import Path

import pytest

from course.cli.main import main
from tests.batch.samples import QUIZ
from tests.batch.term import COURSE, FIRST, identity, lay_term

DEADLINES = """
due: 2026-10-05 23:59
zone: America/New_York
late_days: 1
penalty: {percent: 10, each: 1 day}
handed_in:
  "4105": 2026-10-08 10:00
"""
MARKS = """
marks:
  - {person: "4100", exercise: 05-quiz, bonus: 0.5, comment: Well put.}
  - {person: "Lind, Carla", exercise: 05-quiz, check: why, points: 0.5}
  - {person: "4106", late: no}
  - {person: "4123", excused: true}
"""


def ros2course(*words: str) -> int:
    return main(["--course", str(COURSE), *words])


@pytest.fixture(scope="module")
def graded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = lay_term(tmp_path_factory.mktemp("term") / "term")
    (folder / "week3").mkdir()
    (folder / "week3/deadlines.yaml").write_text(DEADLINES)
    words = ("--roster", str(folder / "canvas.csv"), "--exercises", QUIZ, "--title", "Quiz on lights")
    assert ros2course("grade", str(folder / "class.zip"), *words, "--out", str(folder / "week3")) == 0
    return folder


@pytest.fixture
def term(graded: Path, tmp_path: Path) -> Path:
    return shutil.copytree(graded, tmp_path / "term")


def rows(term: Path) -> dict[str, dict[str, str]]:
    with (term / "week3/results.csv").open(encoding="utf-8-sig", newline="") as file:
        return {row["id"]: row for row in csv.DictReader(file)}


def test_everybody_of_the_list_has_a_row(term: Path) -> None:
    found = rows(term)
    assert list(found) == [identity(place) for place in range(len(FIRST))]
    assert (found["4122"]["total"], found["4122"]["remarks"]) == ("0", "Nothing was handed in.")
    assert (found["4103"]["name"], found["4103"]["total"]) == ("Ayd\u0131n, Dilara", "6")


def test_lateness_stands_beside_the_points(term: Path) -> None:
    late, on_time = rows(term)["4105"], rows(term)["4108"]
    assert (late["raw total"], late["total"]) == ("6", "4.8")
    assert late["late"] == "2 days 10 hours 1 minute late (1 late day used)"
    assert (on_time["raw total"], on_time["total"], on_time["late"]) == ("6", "6", "")
    assert rows(term)["4106"]["late"] == "late, time not known"


def test_peoples_marks_are_kept_through_regrade_and_grade(term: Path) -> None:
    (term / "week3/marks.yaml").write_text(MARKS)
    again = ("grade", str(term / "class.zip"), "--roster", str(term / "canvas.csv"), "--exercises", QUIZ)
    for command in (("regrade", str(term / "week3")), (*again, "--out", str(term / "week3"))):
        assert ros2course(*command) == 0
        found = rows(term)
        assert [found[who]["total"] for who in ("4100", "4102", "4106", "4123")] == ["6.5", "0.5", "6", ""]
        assert found["4123"]["state"] == "excused"
        assert "By hand: +0.5 points. Well put." in (term / "week3/feedback/4100.md").read_text()


def test_a_typo_stops_regrade_before_anything_moves(term: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (term / "week3/marks.yaml").write_text(MARKS.replace("Lind, Carla", "Lind, Karla"))
    before = (term / "week3/results.csv").read_bytes()
    assert ros2course("regrade", str(term / "week3")) == 2
    assert "marks.yaml:4" in capsys.readouterr().err.replace("\n", "")  # a long path is wrapped
    assert (term / "week3/results.csv").read_bytes() == before


def test_the_sheet_goes_back_with_one_column_changed(term: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (term / "week3/marks.yaml").write_text(MARKS)
    original = (term / "canvas.csv").read_bytes()
    assert ros2course("results", "fill", str(term / "canvas.csv"), str(term / "week3")) == 0
    assert "Canvas, Quiz on lights (771): 24 filled in." in capsys.readouterr().out
    filled = (term / "week3/filled-canvas.csv").read_bytes()
    assert (term / "canvas.csv").read_bytes() == original
    pairs = list(zip(original.split(b"\r\n"), filled.split(b"\r\n"), strict=True))
    assert sum(one != other for one, other in pairs) == 24
    totals = {who: row["total"] or "EX" for who, row in rows(term).items()}
    totals.update({"4100": "6.5", "4102": "0.5", "4123": "EX"})
    for one, other in pairs[2:26]:
        who = one.split(b'",')[1].split(b",")[0].decode()
        assert other == one.replace(b",,87.50", f",{totals[who]},87.50".encode()), who


def test_a_file_of_marks_to_fill_in_changes_nothing_by_itself(term: Path) -> None:
    before = rows(term)
    assert ros2course("results", "marks", str(term / "week3")) == 0
    assert (term / "week3/marks.yaml").read_text().count("- person:") == 13
    assert ros2course("regrade", str(term / "week3")) == 0
    assert rows(term) == before
    assert ros2course("results", "marks", str(term / "week3")) == 2


def test_the_page_has_the_title_the_remarks_and_what_is_late(term: Path) -> None:
    assert ros2course("report", str(term / "week3")) == 0
    page = (term / "week3/report.html").read_text(encoding="utf-8")
    assert "<h1>Quiz on lights: marks</h1>" in page
    assert '"dated":true,"remarked":true' in page and '"late":"2 days 10 hours' in page
    assert ros2course("report", str(term / "week3"), "--title", "Week <3>") == 0
    assert "<h1>Week &lt;3&gt;: marks</h1>" in (term / "week3/report.html").read_text(encoding="utf-8")
