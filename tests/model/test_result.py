"""Results: points, verdicts, and the way through JSON."""

from __future__ import annotations

import json
from typing import Any

import pytest

from course.errors import DamagedData
from course.model import replace
from course.model.result import (
    SCHEMA_VERSION,
    CheckResult,
    Feedback,
    Location,
    Outcome,
    Result,
    Timing,
    Verdict,
    from_json,
    not_applicable,
    to_dict,
    to_json,
    verdict_of,
)

FEEDBACK = Feedback(
    "it failed – 日本語 ✓",
    "a",
    "b",
    (Location("src/a.py", 3), Location("src/b.py")),
    "try `this`",
    ("1", "\x1b[31m2"),
)


def check(outcome: Outcome, points: float = 1, **more: Any) -> CheckResult:
    return CheckResult(f"{outcome.value}{points}", "a title", points, outcome, **more)


PASSED, FAILED = check(Outcome.PASSED), check(Outcome.FAILED, 2, feedback=FEEDBACK)
SKIPPED = check(Outcome.SKIPPED, 3, skipped_because='needs "a title"')
NOT_HERE = check(Outcome.NOT_APPLICABLE, 7, skipped_because="no package index")
ERROR = check(Outcome.ERROR, 4, feedback=Feedback("our fault"))
BONUS, NO_BONUS = check(Outcome.PASSED, 5, bonus=True), check(Outcome.FAILED, 6, bonus=True)


@pytest.mark.parametrize(
    "result",
    [
        Result(
            "18-publisher",
            Verdict.NOT_PASSED,
            (PASSED, FAILED, SKIPPED, ERROR, BONUS),
            Timing(1.5, 2.25, 4.0),
        ),
        Result("x", Verdict.OUR_ERROR, (), Timing(), FEEDBACK, "namespaces", ("one note", "another")),
        Result("y", Verdict.NOT_AVAILABLE),
        Result("", Verdict.PASSED, (PASSED,)),
        Result("z", Verdict.NOT_APPLICABLE, (NOT_HERE,), bonus=True),
        not_applicable("z", "it is about your own machine"),
    ],
)
@pytest.mark.parametrize("indent", [None, 2])
def test_a_result_comes_back_as_it_was(result: Result, indent: int | None) -> None:
    back = from_json(to_json(result, indent=indent))
    assert back == result
    assert hash(back) == hash(result)


def test_the_json_form_holds_the_sums_and_plain_words() -> None:
    data = to_dict(Result("x", Verdict.NOT_PASSED, (PASSED, FAILED, BONUS)))
    assert (data["schema"], data["points"], data["max_points"]) == (SCHEMA_VERSION, 6, 3)
    found = json.loads(to_json(Result("x", Verdict.NOT_PASSED, (FAILED,))))
    assert (found["verdict"], found["checks"][0]["outcome"]) == ("not passed", "failed")
    assert found["checks"][0]["feedback"]["where"][0] == {"file": "src/a.py", "line": 3}


@pytest.mark.parametrize(
    "text",
    [
        "",
        "no json",
        "5",
        "null",
        "[]",
        "{}",
        '{"schema": 0}',
        f'{{"schema": {SCHEMA_VERSION}}}',
        '{"schema": "1"}',
    ],
)
def test_anything_else_is_refused(text: str) -> None:
    with pytest.raises(DamagedData, match="grades"):
        from_json(text, "grades.sqlite3")


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("verdict", "perhaps"),
        ("checks", 5),
        ("checks", [5]),
        ("checks", [{}]),
        ("timing", {"lag": "much"}),
        ("timing", None),
        ("fault", {"expected": "x"}),
        ("fault", "x"),
        ("notes", None),
    ],
)
def test_a_damaged_result_is_refused(field: str, value: object) -> None:
    data = {**to_dict(Result("x", Verdict.PASSED, (PASSED,))), field: value}
    with pytest.raises(DamagedData, match=rf"\$\.{field}"):
        from_json(json.dumps(data))


@pytest.mark.parametrize(
    ("checks", "verdict"),
    [
        ((), Verdict.OUR_ERROR),
        ((PASSED,), Verdict.PASSED),
        ((PASSED, BONUS), Verdict.PASSED),
        ((PASSED, NO_BONUS), Verdict.PASSED),
        ((PASSED, FAILED), Verdict.NOT_PASSED),
        ((PASSED, SKIPPED), Verdict.NOT_PASSED),
        ((FAILED,), Verdict.NOT_PASSED),
        ((PASSED, ERROR), Verdict.OUR_ERROR),
        ((FAILED, ERROR), Verdict.OUR_ERROR),
        ((PASSED, replace(ERROR, bonus=True)), Verdict.OUR_ERROR),
        # What does not apply takes no part.
        ((PASSED, NOT_HERE), Verdict.PASSED),
        ((FAILED, NOT_HERE), Verdict.NOT_PASSED),
        ((BONUS, NOT_HERE), Verdict.NOT_APPLICABLE),
        ((NOT_HERE,), Verdict.NOT_APPLICABLE),
        ((NOT_HERE, ERROR), Verdict.OUR_ERROR),
        # Nothing passes for lack of evidence.
        ((BONUS,), Verdict.NOT_PASSED),
        ((SKIPPED,), Verdict.NOT_PASSED),
    ],
)
def test_verdicts(checks: tuple[CheckResult, ...], verdict: Verdict) -> None:
    assert verdict_of(checks) is verdict


def test_points() -> None:
    checks = (PASSED, FAILED, SKIPPED, ERROR, BONUS, NO_BONUS, NOT_HERE)
    result = Result("x", Verdict.NOT_PASSED, checks)
    assert (result.points, result.max_points) == (1 + 5, 1 + 2 + 3 + 4)
    assert [one.earned for one in result.checks] == [1, 0, 0, 0, 5, 0, 0]


def test_places_as_text() -> None:
    assert [str(place) for place in FEEDBACK.where] == ["src/a.py:3", "src/b.py"]
