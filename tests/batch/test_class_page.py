"""From the folder of results to the page, even while it is being filled."""

from __future__ import annotations

import json
from datetime import datetime, timezone
from pathlib import Path

import pytest
import yaml

from course.batch import class_page
from course.batch.class_page import PICTURES_ROOM, Live, read_class, with_pictures
from course.batch.gradings import Graded, Unit
from course.batch.results import BatchSettings, Results, Submission, keep_settings
from course.cli.main import main
from course.content import Course, open_course
from course.errors import StorageError, UsageError
from course.evidence import mcap_file
from course.evidence.sources import Sources
from course.model import replace
from course.model.result import CheckResult, Outcome, Result, Verdict
from course.report.page.data import ClassPage
from tests.conftest import FIXTURES
from tests.report.pictures.recordings import COUNTER, recording

EXERCISE = "05-quiz"
PEOPLE = ("ada", "bao", "carl")
RIGHT = Result(EXERCISE, Verdict.PASSED, (CheckResult("a", "It is", 1, Outcome.PASSED),))
WRONG = Result(EXERCISE, Verdict.NOT_PASSED, (CheckResult("a", "It is", 1, Outcome.FAILED),))


@pytest.fixture
def course() -> Course:
    return open_course(FIXTURES / "quiz_course")


@pytest.fixture
def out(tmp_path: Path) -> Path:
    """Ada passed, Bao did not, and both were recorded; Carl has not been graded yet."""
    folder = tmp_path / "grades"
    with Results.open(folder) as results:
        results.enter([Submission(one, one.title(), f"{one}.zip", "d") for one in PEOPLE])
        began = datetime.now(timezone.utc)
        keep_settings(results, BatchSettings(tmp_path / "class", (), (EXERCISE,), False, True, began))
    for person, result in (("ada", RIGHT), ("bao", WRONG)):
        file = folder / "evidence" / f"{person}.mcap"
        mcap_file.save(recording(*COUNTER), file, began_ns=10**18)
        grade(folder, person, result, f"evidence/{person}.mcap")
    return folder


def grade(out: Path, person: str, result: Result, evidence: str | None = None) -> None:
    with Results.open(out) as results:
        results.record(Graded(Unit(person, EXERCISE), result, 1.0), "1", evidence)


def page(out: Path, course: Course, room: int = PICTURES_ROOM) -> ClassPage:
    with Results.look(out) as results:
        return with_pictures(read_class(out, results, course), room, lambda done, total: None)


def test_everybody_with_their_pictures(out: Path, course: Course) -> None:
    found = page(out, course)
    assert [sheet.person.name for sheet in found.sheets] == ["Ada", "Bao", "Carl"]
    assert {key: len(drawn) for key, drawn in found.pictures.items()} == {(0, EXERCISE): 3, (1, EXERCISE): 3}
    assert found.not_drawn == 0


def test_without_much_room_those_of_what_did_not_pass_come_first(out: Path, course: Course) -> None:
    one = len(page(out, course).pictures)
    assert one == 2
    tight = page(out, course, 3000)
    assert list(tight.pictures) == [(1, EXERCISE)] and tight.not_drawn == 1
    assert page(out, course, 10).not_drawn == 2


def test_the_code_that_was_handed_in_is_shown(out: Path, course: Course) -> None:
    asked = course.exercise(EXERCISE).files[0]
    seen = replace(
        recording(*COUNTER), sources=Sources({asked: "a: 1\n  b: \x1b[31m2\n", "other.txt": "not asked for"})
    )
    mcap_file.save(seen, out / "evidence/ada.mcap", began_ns=10**18)
    assert page(out, course).code[0, EXERCISE] == {asked: ("a: 1", "  b: 2", "")}


@pytest.mark.parametrize(
    ("code", "results", "shared"),
    [
        ("c = 1\n", (WRONG, WRONG), [["ada", "bao", "carl"]]),
        ("c = 2\n", (WRONG, WRONG), [["ada", "bao"], "carl"]),
        ("c = 1\n", (replace(WRONG, verdict=Verdict.OUR_ERROR), WRONG), ["ada", ["bao", "carl"]]),
        ("c = 1\n", (WRONG, RIGHT), [["ada", "bao"], "carl"]),
        ("", (WRONG, WRONG), [["ada", "bao"], "carl"]),
    ],
)
def test_people_with_equal_code_and_results_share_an_entry_of_marks(
    out: Path, code: str, results: tuple[Result, Result], shared: list[str | list[str]]
) -> None:
    handed_in = {
        "ada": ("a = 1\n", results[0]),
        "bao": ("b = 1  # mine\n", WRONG),
        "carl": (code, results[1]),
    }
    for person, (text, result) in handed_in.items():
        seen = replace(recording(*COUNTER), sources=Sources({"n.py": text} if text else {}))
        mcap_file.save(seen, out / f"evidence/{person}.mcap", began_ns=10**18)
        grade(out, person, result, f"evidence/{person}.mcap")
    assert main(["--course", str(FIXTURES / "quiz_course"), "results", "marks", str(out)]) == 0
    marks = yaml.safe_load((out / "marks.yaml").read_text())["marks"]
    assert [one["person"] for one in marks] == shared


@pytest.mark.slow
def test_many_are_drawn_by_several_processes_alike(
    out: Path, course: Course, monkeypatch: pytest.MonkeyPatch
) -> None:
    alone = page(out, course).pictures
    monkeypatch.setattr(class_page, "_FEW", 1)
    assert page(out, course).pictures == alone


@pytest.mark.parametrize("content", [b"", b"no recording", None])
def test_a_recording_that_cannot_be_read_is_no_picture(
    out: Path, course: Course, content: bytes | None
) -> None:
    file = out / "evidence/bao.mcap"
    file.unlink() if content is None else file.write_bytes(content)
    found = page(out, course)
    assert found.pictures[1, EXERCISE] == () and len(found.pictures[0, EXERCISE]) == 3


def test_looking_changes_nothing(out: Path, course: Course) -> None:
    with Results.look(out) as results, pytest.raises(StorageError):
        results.note("key", "value")


def test_what_is_read_is_of_one_moment(out: Path) -> None:
    with Results.look(out) as results, results.at_one_moment():
        before = results.verdicts()
        grade(out, "carl", RIGHT)
        assert results.verdicts() == before
    with Results.look(out) as results:
        assert sum(results.verdicts().values()) == 3


def test_a_folder_without_results_is_told(tmp_path: Path, course: Course) -> None:
    with pytest.raises(UsageError, match="no results"):
        Live(tmp_path, course).news()


def test_news_come_when_something_was_graded(out: Path, course: Course) -> None:
    live = Live(out, course)
    tag, text = live.news()
    assert live.tag() == tag and live.news() == (tag, text)
    assert json.loads(text)["data"]["people"][2]["marks"][0][0] == "not handed in"
    grade(out, "carl", WRONG)
    assert live.tag() != tag
    assert json.loads(live.news()[1])["data"]["people"][2]["marks"][0][0] == "not passed"


def test_a_submission_is_drawn_when_it_is_asked_for(out: Path, course: Course) -> None:
    live = Live(out, course)
    (mark,) = json.loads(live.submission(1) or "")["marks"]
    assert len(mark["pictures"]) == 3
    assert live.submission(3) is None
    assert "Ada" in live.page()
