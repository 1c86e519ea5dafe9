"""results.json keeps to its schema, whatever was handed in; the schema keeps to the document."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

import jsonschema
import pytest

from course.model.gradebook import Gradebook, GradedSubmission
from course.model.result import Outcome, Verdict
from course.report.gradebook import class_files
from course.report.gradebook.sheets import COMPLETE, EXCUSED, INCOMPLETE, MARKED, NOT_HANDED_IN, sheets
from tests.report.gradebook import hostile, samples

VALIDATOR = jsonschema.Draft202012Validator(samples.SCHEMA)


def text_of(book: Gradebook) -> str:
    return "".join(class_files.pieces(book, hostile.CLEANER, sheets(book, hostile.CLEANER)))


def read(*graded: GradedSubmission) -> Any:
    data = json.loads(text_of(samples.gradebook(*graded)))
    VALIDATOR.validate(data)
    return data


def test_the_schema_is_one() -> None:
    jsonschema.Draft202012Validator.check_schema(samples.SCHEMA)
    assert samples.SCHEMA["properties"]["schema"]["const"] == class_files.VERSION


def test_a_class_is_valid_and_whole() -> None:
    data = read(*samples.CLASS.graded)
    assert [one["id"] for one in data["graded"]] == ["ada", "bao", "carl", "dilara", "emre"]
    assert [one["points"] for one in data["graded"]] == [5, 3, 1, None, 0]
    assert data["graded"][1]["results"][0]["checks"][2]["feedback"]["where"][0]["line"] == 21
    assert data["began"] == "2026-03-02T09:00:00+00:00"


def test_an_empty_class_is_valid() -> None:
    assert read()["graded"] == []


@pytest.mark.parametrize("text", hostile.TEXTS, ids=lambda text: ascii(text[:20]))
def test_hostile_texts_are_valid_and_harmless_in_a_web_page(text: str) -> None:
    read(hostile.graded(text))
    assert "<" not in text_of(samples.gradebook(hostile.graded(text)))


def test_the_schema_refuses_what_must_not_be_there() -> None:
    good = read(samples.BAO)
    for path, wrong in (
        (("schema",), 2),
        (("course",), "\x1b[31m"),
        (("seed",), 3),
        (("graded", 0, "state"), "unknown"),
        (("graded", 0, "name"), "\u202e"),
        (("graded", 0, "results", 0, "points"), None),
        (("graded", 0, "results", 0, "containment"), "namespaces"),
        (("graded", 0, "results", 0, "checks", 0, "outcome"), "?"),
        (("graded", 0, "results", 0, "checks", 2, "feedback", "where", 0, "line"), 0),
    ):
        bad = json.loads(json.dumps(good))
        place: Any = bad
        for key in path[:-1]:
            place = place[key]
        place[path[-1]] = wrong
        assert not VALIDATOR.is_valid(bad), path


def test_the_schema_knows_every_verdict_outcome_and_state() -> None:
    parts = samples.SCHEMA["$defs"]
    verdicts = {*(verdict.value for verdict in Verdict), NOT_HANDED_IN, EXCUSED, MARKED}
    assert set(parts["result"]["properties"]["verdict"]["enum"]) == verdicts
    assert set(parts["check"]["properties"]["outcome"]["enum"]) == {outcome.value for outcome in Outcome}
    assert set(parts["graded"]["properties"]["state"]["enum"]) == {
        COMPLETE,
        INCOMPLETE,
        NOT_HANDED_IN,
        EXCUSED,
    }


def test_every_field_is_required_and_described() -> None:
    objects = [
        samples.SCHEMA,
        *(part for part in samples.SCHEMA["$defs"].values() if part.get("type") == "object"),
    ]
    for part in objects:
        assert part["required"] == list(part["properties"]) and part["additionalProperties"] is False
        assert all(
            part["properties"][name].get("description") or name == "schema" for name in part["required"]
        )


def test_a_piece_is_there_before_the_next_submission_is_read() -> None:
    def endless() -> Iterator[Any]:
        yield samples.sheet_of(samples.ADA)
        raise AssertionError("read ahead")

    made = class_files.pieces(samples.CLASS, samples.CLEANER, endless())
    assert '"graded": [' in next(made)
    assert '"id": "ada"' in next(made)
