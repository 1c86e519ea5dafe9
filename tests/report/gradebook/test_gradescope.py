"""Gradescope's results.json: its fields, and points that add up."""

from __future__ import annotations

import json
from typing import Any

import jsonschema
import pytest

from course.model.gradebook import GradedSubmission
from course.report.gradebook import gradescope
from tests.report.gradebook import hostile, samples

FORMATS = {"enum": ["text", "html", "simple_format", "md", "ansi"]}
VISIBILITY = {"enum": ["hidden", "after_due_date", "after_published", "visible"]}
TEXT, NUMBER = {"type": "string"}, {"type": "number"}
TEST = {
    "type": "object",
    "additionalProperties": False,
    "properties": {
        "score": NUMBER,
        "max_score": NUMBER,
        "status": {"enum": ["passed", "failed"]},
        "name": TEXT,
        "name_format": FORMATS,
        "number": TEXT,
        "output": TEXT,
        "output_format": FORMATS,
        "tags": {"type": "array", "items": TEXT},
        "visibility": VISIBILITY,
        "extra_data": {"type": "object"},
    },
}
# As their documentation tells; nothing is published as a schema.
SCHEMA = {
    "type": "object",
    "additionalProperties": False,
    "required": ["score"],
    "properties": {
        "score": NUMBER,
        "execution_time": NUMBER,
        "output": TEXT,
        "output_format": FORMATS,
        "test_output_format": FORMATS,
        "test_name_format": FORMATS,
        "visibility": VISIBILITY,
        "stdout_visibility": VISIBILITY,
        "extra_data": {"type": "object"},
        "tests": {"type": "array", "items": TEST},
    },
}


def read(graded: GradedSubmission) -> Any:
    text = gradescope.as_text(samples.sheet_of(graded, hostile.CLEANER))
    text.encode("utf-8")
    data = json.loads(text)
    jsonschema.Draft202012Validator(SCHEMA).validate(data)
    assert "hidden" not in [data["visibility"], *(test.get("visibility") for test in data["tests"])]
    return data


def test_points_add_up_to_the_score() -> None:
    for graded, score in ((samples.ADA, 5), (samples.BAO, 3), (samples.CARL, 1), (samples.EMRE, 0)):
        data = read(graded)
        assert data["score"] == score == sum(test["score"] for test in data["tests"])
        assert sum(test["max_score"] for test in data["tests"]) == 5


def test_only_what_passed_is_called_passed() -> None:
    statuses = [test["status"] for test in read(samples.BAO)["tests"]]
    assert statuses == ["passed", "passed", "failed", "failed", "passed"]


def test_our_error_looks_neither_passed_nor_failed() -> None:
    data = read(samples.DILARA)
    (test,) = data["tests"]
    assert "status" not in test and "score" not in test and "max_score" not in test
    assert data["output"].startswith("Not everything could be checked, through no fault of yours.")
    assert data["extra_data"]["state"] == "incomplete"


def test_bonus_and_what_does_not_apply() -> None:
    by_name = {test["name"]: test for test in read(hostile.graded("text"))["tests"]}
    assert (by_name["18-publisher: More"]["score"], by_name["18-publisher: More"]["max_score"]) == (0.1, 0)
    assert "score" not in by_name["18-publisher: Elsewhere"]


@pytest.mark.parametrize("text", hostile.TEXTS, ids=lambda text: ascii(text[:20]))
def test_hostile_texts_are_shown_as_text(text: str) -> None:
    data = read(hostile.graded(text))
    assert {data[f"{what}output_format"] for what in ("", "test_")} == {"text"}
    assert data["test_name_format"] == "text"
