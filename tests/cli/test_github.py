"""In a step of GitHub Actions, `grade` writes what the step shows and what Classroom reads."""

from __future__ import annotations

import base64
import json
import re
from collections.abc import Iterator
from datetime import datetime, timezone
from pathlib import Path

import pytest

from course.batch.intake import Found, Part, Placement, SubmissionKind
from course.cli.github import hand_over
from course.errors import StorageError
from course.model import replace
from course.model.feedback import Feedback, Location
from course.model.gradebook import Gradebook, GradedExercise, GradedSubmission, HandMark, Person
from course.model.gradebook import Person as Learner
from course.model.result import CheckResult, Outcome, Result, Verdict
from course.report.gradebook.cleaning import Cleaner

NODE = "ros2_tutorial_workspace/src/lamps/lamps/lamp.py"
NOW = datetime(2026, 11, 21, tzinfo=timezone.utc)
FAILED = CheckResult(
    "rate", "publishes", 2, Outcome.FAILED, feedback=Feedback("Too slow.", where=(Location(NODE, 7),))
)


class _Class:
    def __iter__(self) -> Iterator[GradedSubmission]:
        result = Result("18-publisher", Verdict.NOT_PASSED, (FAILED,))
        yield GradedSubmission(Learner("ada", "Ada"), "repo", (result,))


@pytest.fixture
def book() -> Gradebook:
    exercise = GradedExercise("18-publisher", "A publisher", 2)
    return Gradebook("ros2course", (exercise,), _Class(), NOW, NOW)


def found(*places: Placement) -> Found:
    part = Part("repo", Path("/somewhere/repo"))
    return Found(Person("ada", "Ada"), "repo", SubmissionKind.WORKSPACE, "", (), (), (), (part,), places)


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
        ((Placement("", ""),), NODE),
        ((Placement("src", "ros2_tutorial_workspace/src"),), "src/lamps/lamps/lamp.py"),
        ((Placement("work/lamps", "ros2_tutorial_workspace/src/lamps"),), "work/lamps/lamps/lamp.py"),
        ((), NODE),
    ],
)
def test_lines_are_annotated_where_they_lie_in_the_clone(
    book: Gradebook,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    places: tuple[Placement, ...],
    shown: str,
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


CLASSROOM = {
    "CLASSROOM": "cs50",
    "ASSIGNMENT": "lamps",
    "SUBMISSION_TAG": "submit/20261121T000000Z-abc1234",
    "USERNAME": "ada",
    "COMMIT_URL": "https://github.com/o/cs50-lamps-ada/commit/abc",
    "RELEASE_URL": "https://github.com/o/cs50-lamps-ada/releases/tag/x",
    "GITHUB_ACTOR": "ada",
    "GITHUB_ACTOR_ID": "17",
}


def classroom50(folder: Path, *by_hand: HandMark) -> dict[str, object]:
    result = Result(
        "18-publisher", Verdict.NOT_PASSED, (FAILED, replace(FAILED, id="b", outcome=Outcome.PASSED))
    )
    graded = GradedSubmission(Learner("ada", "Ada"), "repo", (result,), by_hand=by_hand)
    made = Gradebook("ros2course", (GradedExercise("18-publisher", "A publisher", 4),), (graded,), NOW, NOW)
    hand_over(made, Cleaner(), found(), folder, {**CLASSROOM, "GITHUB_WORKSPACE": str(folder)})
    read: dict[str, object] = json.loads((folder / "result.json").read_text())
    return read


def test_classroom_50_gets_whole_points(tmp_path: Path) -> None:
    trap = tmp_path / "elsewhere"
    trap.write_text("mine")
    (tmp_path / "result.json").symlink_to(trap)
    made = classroom50(tmp_path, HandMark("18-publisher", bonus=0.5))
    assert trap.read_text() == "mine"
    assert (made["schema"], made["owner"], made["assignment_type"]) == (
        "classroom50/result/v1",
        "ada",
        "individual",
    )
    assert (made["score"], made["max-score"], made["review"]) == (3, 4, CLASSROOM["COMMIT_URL"])
    assert made["submitted_by"] == {"username": "ada", "id": 17}
    (test,) = made["tests"]  # type: ignore[misc]
    assert (test["test-name"], test["passed"], test["score"], test["max-score"], test["points"]) == (
        *("18-publisher: A publisher", False, 3, 4, 2.5),
    )
    assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", str(made["datetime"]))
    required = {
        "schema",
        "classroom",
        "assignment",
        "assignment_type",
        "owner",
        "submission",
        "commit",
        "release",
    }
    required |= {"review", "datetime", "score", "max-score", "tests"}
    assert set(made) == required | {"graded_at", "submitted_by"}


def test_classroom_50_never_gets_more_than_the_maximum(tmp_path: Path) -> None:
    made = classroom50(tmp_path, HandMark("18-publisher", bonus=9))
    assert (made["score"], made["max-score"]) == (4, 4)


def test_without_its_runner_nothing_is_written(tmp_path: Path, book: Gradebook) -> None:
    told = {name: text for name, text in CLASSROOM.items() if name != "SUBMISSION_TAG"}
    hand_over(book, Cleaner(), found(), tmp_path, {**told, "GITHUB_WORKSPACE": str(tmp_path)})
    assert list(tmp_path.iterdir()) == []
