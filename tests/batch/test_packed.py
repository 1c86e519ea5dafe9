"""`pack` makes a zip that can be graded by itself, and `grade` says where its judgment differs."""

from __future__ import annotations

import csv
import json
import shutil
import zipfile
from pathlib import Path

import pytest

from course.cli.main import main
from course.content import open_course
from course.grading import trial
from course.model.result import Result, Verdict
from tests.batch.samples import QUIZ
from tests.batch.term import COURSE, lay_term

ANSWERS = f"answers/{QUIZ}.yaml"
MANIFEST = ".ros2course/hand-in.json"


def ros2course(*words: str) -> int:
    return main(["--course", str(COURSE), *words])


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    home = tmp_path / "home"
    assert ros2course("init", str(home)) == 0
    monkeypatch.chdir(home)
    monkeypatch.setenv("ROS2COURSE_HOME", str(home))
    return home


@pytest.fixture
def solved(home: Path, capsys: pytest.CaptureFixture[str]) -> Path:
    course = open_course(COURSE)
    trial.lay_solution(course, course.exercise(QUIZ), home)
    (home / "diary.txt").write_text("Nobody's business.")
    capsys.readouterr()
    return home


def test_what_is_packed_is_what_is_needed(solved: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert ros2course("pack", QUIZ) == 0
    assert f"{QUIZ}  passed  6 of 6" in capsys.readouterr().out
    with zipfile.ZipFile(solved / "hand-in.zip") as archive:
        assert sorted(archive.namelist()) == [MANIFEST, ".ros2course/home.json", ANSWERS]
        told = json.loads(archive.read(MANIFEST))
    assert told["claims"][0]["points"] == 6 and told["versions"]["ros2course"]
    assert set(told["files"]) == {".ros2course/home.json", ANSWERS}
    assert ros2course("pack", QUIZ, "--out", "again.zip") == 0  # the second zip does not contain the first
    with zipfile.ZipFile(solved / "again.zip") as archive:
        assert len(archive.namelist()) == 3


def test_what_is_wrong_is_packed_and_said(solved: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (solved / ANSWERS).write_text("why: It saves oil\n")
    assert ros2course("pack", QUIZ) == 1
    said = capsys.readouterr().out
    assert "not passed  0 of 6" in said and "check 05-quiz" in said


def test_nothing_is_no_zip(home: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert ros2course("pack", QUIZ) == 2
    assert "no files of 05-quiz" in capsys.readouterr().err
    assert not (home / "hand-in.zip").exists()


def test_a_package_that_is_missing_is_named(
    home: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """`grade` would use the course's own package, with a different result."""
    course = open_course()
    ours = ["--course", str(course.root)]
    trial.lay_solution(course, course.exercise("18-publisher"), home)
    judged = Result("18-publisher", Verdict.NOT_PASSED)
    monkeypatch.setattr("course.cli.pack._checked", lambda *_: judged)
    said = "hand-in.zip lacks the package package_with_interfaces"
    assert main([*ours, "pack", "18-publisher"]) == 1
    assert said not in " ".join(capsys.readouterr().out.split())
    shutil.rmtree(home / "ros2_tutorial_workspace/src/package_with_interfaces")
    assert main([*ours, "pack", "18-publisher"]) == 1
    assert said in " ".join(capsys.readouterr().out.split())


def _again(packed: Path, changed: dict[str, bytes], to: Path) -> None:
    with zipfile.ZipFile(packed) as old, zipfile.ZipFile(to, "w") as new:
        for name in old.namelist():
            new.writestr(name, changed.get(name, old.read(name)))


def test_a_class_that_packed(solved: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Among 22 other submissions: an honest zip, a changed one, one that lies, odd manifests."""
    term = lay_term(tmp_path / "term")
    with zipfile.ZipFile(term / "class.zip") as archive:
        archive.extractall(term / "class")
    assert ros2course("pack", QUIZ) == 0
    packed = solved / "hand-in.zip"
    wrong = b"why: It saves oil\n"
    lie = (
        zipfile.ZipFile(packed).read(MANIFEST).replace(b'"6.0"', b'"7"').replace(b"3.", b"=cmd|\\u001b[31m ")
    )
    for number, changed in enumerate(
        ({}, {ANSWERS: wrong}, {ANSWERS: wrong, MANIFEST: lie}, {MANIFEST: b"[" * 9000}, {MANIFEST: b"{}"})
    ):
        _again(packed, changed, term / f"class/pack{number}_{4201 + number}_{9000 + number}_hand-in.zip")
    capsys.readouterr()
    assert ros2course("grade", str(term / "class"), "--exercises", QUIZ, "--out", str(term / "out")) == 0
    said = " ".join(capsys.readouterr().err.split())
    assert "4202: 05-quiz had 6 of 6 points where it was packed (ros2course " in said
    with (term / "out/results.csv").open(encoding="utf-8-sig", newline="") as file:
        rows = {row["id"]: row for row in csv.DictReader(file)}
    assert len(rows) == 27
    assert (rows["4201"]["total"], rows["4201"]["remarks"]) == ("6", "")
    changed_later = rows["4202"]["remarks"]
    assert f"Files were changed after `pack` checked them. ({ANSWERS})" in changed_later
    assert "and has 0 of 6 here. Different: " in changed_later
    assert "\x1b" not in rows["4203"]["remarks"] and rows["4203"]["total"] == "0"
    assert [rows[who]["total"] for who in ("4204", "4205")] == ["6", "6"]
    for who in ("4204", "4205"):
        assert rows[who]["remarks"].startswith("The manifest that `pack` wrote cannot be read.")
    letter = (term / "out/feedback/4202.md").read_text(encoding="utf-8")
    assert "where it was packed" in letter
    assert ros2course("regrade", str(term / "out")) == 0
    assert (term / "out/feedback/4202.md").read_text(encoding="utf-8") == letter
