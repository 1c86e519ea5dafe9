"""`ros2course similar` on small classes."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

import pytest

from course.content import open_course
from course.errors import ExitCode
from course.grading import trial
from tests.cli.conftest import REPO, Ros2course
from tests.extras.similar.classes import GARDEN, RENAMED, SHOP, hand_in


@pytest.fixture
def handed_in(tmp_path: Path) -> Path:
    folder = tmp_path / "handed-in"
    for name, content in (("ann", SHOP), ("bob", GARDEN), ("eve", RENAMED)):
        hand_in(folder, name, content)
    return folder


def test_it_shows_pairs_and_ends_well(ros2course: Ros2course, handed_in: Path) -> None:
    run = ros2course("similar", str(handed_in))
    assert (run.code, run.err) == (ExitCode.PASSED, "")
    assert "1.  ann  100%, 21 lines" in run.out and "    eve  100%, 21 lines" in run.out
    assert "bob" not in run.out
    assert max(map(len, run.out.split("\n"))) <= 80


def test_nothing_alike_ends_well_too(ros2course: Ros2course, handed_in: Path) -> None:
    run = ros2course("similar", str(handed_in), "--lines", "99")
    assert run.code == ExitCode.PASSED and "3 submissions compared. No pair is alike" in run.out


def test_only_the_code_of_some_exercises(ros2course: Ros2course, handed_in: Path, small_course: Path) -> None:
    words = ("similar", str(handed_in), "--exercises", "04-light")
    run = ros2course("--course", str(small_course), *words)
    assert run.code == ExitCode.PASSED and "No pair is alike" in run.out


def test_the_page_is_written(ros2course: Ros2course, handed_in: Path, tmp_path: Path) -> None:
    page = tmp_path / "new" / "alike.html"
    assert ros2course("similar", str(handed_in), "--out", str(page)).code == ExitCode.PASSED
    text = page.read_text(encoding="utf-8")
    assert text.startswith("<!DOCTYPE html>") and "class Store" in text
    assert [file.name for file in page.parent.iterdir()] == ["alike.html"]


@pytest.mark.parametrize("out", ["alike.txt", "."])
def test_another_ending_is_refused_before_anything_is_read(
    ros2course: Ros2course, handed_in: Path, out: str
) -> None:
    run = ros2course("similar", str(handed_in / "nowhere"), "--out", out)
    assert run.code == ExitCode.USAGE and ".html" in run.err


def test_solutions_are_asked_for(ros2course: Ros2course, handed_in: Path, small_course: Path) -> None:
    (small_course / "solutions/04-lanterns/shop.py").write_text(SHOP, encoding="utf-8")
    assert "solution 04-lanterns" not in ros2course("similar", str(handed_in)).out
    assert "solution 04-lanterns" in ros2course("similar", str(handed_in), "--with-solutions").out
    assert "No pair is" in ros2course("similar", str(handed_in), "--without-solutions").out
    both = ros2course("similar", str(handed_in), "--with-solutions", "--without-solutions")
    assert both.code == ExitCode.USAGE


def test_without_the_library(
    ros2course: Ros2course, handed_in: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "scanoss_winnowing.winnowing", None)
    run = ros2course("similar", str(handed_in))
    assert run.code == ExitCode.MISSING_HERE
    assert "pip install" in run.err and "scanoss-winnowing" in run.err


@pytest.mark.parametrize("words", [("nowhere",), (".", "--threshold", "0"), (".", "--threshold", "101")])
def test_wrong_words(ros2course: Ros2course, words: tuple[str, ...]) -> None:
    assert ros2course("similar", *words).code == ExitCode.USAGE


RENAMING = (("node", "thing"), ("point", "spot"), ("logger", "log_book"), ("request", "question"), ("'", '"'))


def a_class(folder: Path) -> None:
    """Three ways to solve an exercise of the real course, and a copy with other names and comments."""
    course = open_course()
    exercise = course.exercise("20-server")
    for name, way in zip(("Amy Ant", "Ben Bee", "Cleo Cat"), exercise.alternatives(), strict=True):
        (folder / name).mkdir(parents=True)
        trial.lay_alternative(course, exercise, way, folder / name)
    shutil.copytree(folder / "Cleo Cat", folder / "Gus Gnu")
    for file in (folder / "Gus Gnu").rglob("*_node.py"):
        text = file.read_text(encoding="utf-8").replace("\n    def ", "\n    # All my own.\n    def ")
        for old, new in RENAMING:
            text = text.replace(old, new)
        file.write_text(text, encoding="utf-8")


def test_the_document_shows_what_the_command_prints(ros2course: Ros2course, tmp_path: Path) -> None:
    a_class(tmp_path / "class")
    printed = ros2course("similar", str(tmp_path / "class"), course=None).out
    text = (REPO / "docs" / "similar.md").read_text(encoding="utf-8")
    command, _, shown = text.split("```text\n$ ")[1].partition("\n")
    assert command == "ros2course similar class/"
    assert "\n".join(map(str.rstrip, printed.split("\n"))) == shown.split("```")[0]
