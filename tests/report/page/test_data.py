"""The page's data: complete, clean, and unable to leave its element."""

from __future__ import annotations

import json

import pytest

from course.report.page.data import as_json, class_data, submission_data
from course.report.page.views import changes
from tests.report.gradebook.hostile import MACHINE, SECRET, TEXTS
from tests.report.page.classes import hostile, small


def test_the_table() -> None:
    data = class_data(small())
    assert data["exercises"] == [{"id": "18-publisher", "title": "A publisher", "max": 5, "bonus": False}]
    marks = {one["name"]: one["marks"][0][:3] for one in data["people"]}
    assert marks == {
        "Ada Okafor": ["passed", 5, 5],
        "Bảo Nguyễn": ["not passed", 3, 5],
        "Carl Lind": ["not passed", 1, 5],
        "Dilara Aydın": ["our error", None, None],
        "Emre Kaya": ["not handed in", 0, 5],
    }


def test_a_submission_has_its_feedback_and_its_pictures() -> None:
    told = submission_data(small(), 1)
    (mark,) = told["marks"]
    failed = next(check for check in mark["checks"] if check["outcome"] == "failed")
    assert failed["mark"] == "no"
    assert failed["points"] == "0 of 1"
    assert ["seen", "/amazing_quotes"] in failed["why"]["parts"]
    assert len(mark["pictures"]) == 3
    (code,) = mark["code"]
    assert code["found"] == [(21, "The node publishes on `/amazing_quotes`, not `/amazing_quote`.")]
    assert code["lines"][20] == "line_21 = 21"


def test_an_earlier_run_is_beside_this_one() -> None:
    page = small()
    before = {one["name"]: one["before"] for one in class_data(page)["people"]}
    assert before["Ada Okafor"] == before["Carl Lind"] == 1 and before["Emre Kaya"] is None
    assert submission_data(page, 0)["marks"][0]["before"] == "Not passed yet 1 of 5 points"
    assert [(one.words, one.people) for one in changes(page)] == [("not passed → passed", (0,))]


def test_who_handed_nothing_in_is_told_so() -> None:
    told = submission_data(small(), 4)
    assert told["says"] == ["Nothing of yours was found. If you did hand something in, tell your instructor."]
    assert told["marks"][0]["notes"] == ["Nothing was handed in for this exercise."]


def test_our_error_is_told_without_its_traceback() -> None:
    text = json.dumps(submission_data(small(), 3))
    assert "Traceback" not in text and "60 s" not in text
    assert "It does not count" in text or "does not count" in text


@pytest.mark.slow
@pytest.mark.parametrize("place", range(len(TEXTS)))
def test_nothing_leaves_that_must_not(place: int) -> None:
    page = hostile()
    text = json.dumps([class_data(page), submission_data(page, place)], ensure_ascii=False)
    for forbidden in (MACHINE, SECRET, "\x1b", "\x9b", "\u202e", "explained ", "Traceback"):
        assert forbidden not in text
    assert len(text) < 400_000  # also of a megabyte of output


def test_data_cannot_leave_its_element() -> None:
    text = as_json(["</script><!--<script>", "a\u2028b\u2029", "&lt;"])
    assert not set("<>&\u2028\u2029") & set(text)
    assert json.loads(text) == ["</script><!--<script>", "a\u2028b\u2029", "&lt;"]
