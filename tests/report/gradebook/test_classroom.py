"""The result of GitHub Classroom's grading reporter."""

from __future__ import annotations

import base64
import json
import re
from typing import Any

import jsonschema
import pytest

from course.model import replace
from course.model.gradebook import GradedSubmission
from course.model.result import Verdict
from course.report.gradebook import github
from tests.report.gradebook import hostile, samples

STATUS = {"enum": ["pass", "fail", "error"]}
TEXT = {"type": "string"}
FIELDS = {
    "name": TEXT,
    "status": STATUS,
    "message": {"type": ["string", "null"]},
    "test_code": TEXT,
    "filename": TEXT,
    "line_no": {"type": "integer"},
    "execution_time": {"type": "string", "pattern": r"^(0|\d+(\.\d+)?s)$"},
    "score": {"type": "number"},
}
SCHEMA = {
    "type": "object",
    "additionalProperties": False,
    "required": ["version", "status", "max_score", "tests"],
    "properties": {
        "version": {"const": 1},
        "status": STATUS,
        "max_score": {"type": "number"},
        "tests": {
            "type": "array",
            "items": {
                "type": "object",
                "additionalProperties": False,
                "required": list(FIELDS),
                "properties": FIELDS,
            },
        },
    },
}


def read(graded: GradedSubmission) -> Any:
    line = github.encoded(samples.sheet_of(graded, hostile.CLEANER))
    assert re.fullmatch(r"[A-Za-z0-9+/]+=*", line)
    data = json.loads(base64.b64decode(line, validate=True))
    jsonschema.Draft202012Validator(SCHEMA).validate(data)
    return data


def test_the_class() -> None:
    told = [(data["status"], data["max_score"]) for data in map(read, samples.CLASS.graded)]
    assert told == [("pass", 5), ("fail", 5), ("fail", 5), ("error", 0), ("fail", 5)]


def test_scores_are_what_was_earned() -> None:
    data = read(samples.BAO)
    assert sum(test["score"] for test in data["tests"]) == 3
    assert [test["status"] for test in data["tests"]] == ["pass", "pass", "fail", "fail", "pass"]


def test_a_failure_has_its_place_and_its_words() -> None:
    test = read(samples.BAO)["tests"][2]
    assert test["filename"].endswith("_node.py") and test["line_no"] == 21
    assert test["message"].startswith("The node publishes on `/amazing_quotes`")
    assert test["test_code"] == ""


def test_an_error_took_no_time() -> None:
    (test,) = read(samples.DILARA)["tests"]
    assert (test["status"], test["execution_time"], test["score"]) == ("error", "0", 0)


def test_what_was_not_judged_as_a_whole_brings_nothing() -> None:
    broken = replace(samples.result("right"), verdict=Verdict.OUR_ERROR)
    data = read(replace(samples.ADA, results=(broken,)))
    assert data["status"] == "error"
    assert [test["score"] for test in data["tests"]] == [0, 0, 0, 0, 0, 0]


def test_no_test_at_all_is_no_pass() -> None:
    empty = samples.sheet_of(samples.ADA)
    assert github.as_data(type(empty)(empty.person, "", (), ()))["status"] == "fail"


@pytest.mark.parametrize("text", hostile.TEXTS, ids=lambda text: ascii(text[:20]))
def test_hostile_texts(text: str) -> None:
    assert len(read(hostile.graded(text))["tests"]) == 5
