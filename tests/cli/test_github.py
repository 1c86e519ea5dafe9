"""In a step of GitHub Actions, `grade` hands over what the step shows and what Classroom reads."""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator
from datetime import datetime, timezone
from pathlib import Path

import pytest

from course.batch.intake import Found, Kind, Part, Person, Place
from course.cli.github import hand_over
from course.errors import StorageError
from course.feedback import Feedback, Location
from course.grading.result import CheckResult, Outcome, Result, Verdict
from course.report.gradebook.cleaning import Cleaner
from course.report.gradebook.model import Gradebook, Graded, GradedExercise
from course.report.gradebook.model import Person as Learner

NODE = "ros2_tutorial_workspace/src/lamps/lamps/lamp.py"
NOW = datetime(2026, 11, 21, tzinfo=timezone.utc)
FAILED = CheckResult(
    "rate", "publishes", 2, Outcome.FAILED, feedback=Feedback("Too slow.", where=(Location(NODE, 7),))
)


class _Class:
    def __iter__(self) -> Iterator[Graded]:
        result = Result("18-publisher", Verdict.NOT_PASSED, (FAILED,))
        yield Graded(Learner("ada", "Ada"), "repo", (result,))


@pytest.fixture
def book() -> Gradebook:
    exercise = GradedExercise("18-publisher", "A publisher", 2)
    return Gradebook("ros2course", (exercise,), _Class(), NOW, NOW)


def found(*places: Place) -> Found:
    part = Part("repo", Path("/somewhere/repo"))
    return Found(Person("ada", "Ada"), "repo", Kind.WORKSPACE, "", (), (), (), (part,), places)


def test_a_class_gets_a_summary_and_nothing_else(
    book: Gradebook, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    summary, output = tmp_path / "summary", tmp_path / "output"
    summary.write_text("# Before\n")
    environ = {"GITHUB_ACTIONS": "true", "GITHUB_STEP_SUMMARY": str(summary), "GITHUB_OUTPUT": str(output)}
    hand_over(book, Cleaner({}), None, tmp_path, environ)
    text = summary.read_text()
    assert text.startswith("# Before\n# ros2course")
    assert "Too slow." in text
    assert not output.exists()
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize(
    ("places", "shown"),
    [
        ((Place("", ""),), NODE),
        ((Place("src", "ros2_tutorial_workspace/src"),), "src/lamps/lamps/lamp.py"),
        ((Place("work/lamps", "ros2_tutorial_workspace/src/lamps"),), "work/lamps/lamps/lamp.py"),
        ((), NODE),
    ],
)
def test_lines_are_annotated_where_they_lie_in_the_clone(
    book: Gradebook, tmp_path: Path, capsys: pytest.CaptureFixture[str], places: tuple[Place, ...], shown: str
) -> None:
    hand_over(book, Cleaner({}), found(*places), tmp_path, {"GITHUB_ACTIONS": "true"})
    line = capsys.readouterr().out
    assert line.startswith("::error ")
    assert f"file={shown},line=7" in line
    below = {"GITHUB_ACTIONS": "true", "GITHUB_WORKSPACE": str(tmp_path.parent)}
    hand_over(book, Cleaner({}), found(*places), tmp_path, below)
    if places:
        assert f"file={tmp_path.name}/{shown},line=7" in capsys.readouterr().out


def test_classroom_reads_the_step_s_output(book: Gradebook, tmp_path: Path) -> None:
    output = tmp_path / "output"
    hand_over(book, Cleaner({}), found(), tmp_path, {"GITHUB_OUTPUT": str(output)})
    name, _, value = output.read_text().strip().partition("=")
    assert name == "result"
    data = json.loads(base64.b64decode(value))
    assert (data["version"], data["status"], data["max_score"]) == (1, "fail", 2)


def test_elsewhere_nothing_is_handed_over(
    book: Gradebook, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    hand_over(book, Cleaner({}), found(), tmp_path, {})
    assert capsys.readouterr().out == ""
    assert list(tmp_path.iterdir()) == []


def test_a_file_that_cannot_be_written_is_told(book: Gradebook, tmp_path: Path) -> None:
    with pytest.raises(StorageError, match="could not be written"):
        hand_over(book, Cleaner({}), found(), tmp_path, {"GITHUB_OUTPUT": "/dev/null/output"})
