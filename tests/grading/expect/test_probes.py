"""What is said about code that a probe could not import, or that answered wrongly."""

from __future__ import annotations

import json
from typing import Any

import pytest

from course.errors import OurFault
from course.evidence.home_files import HomeEntry
from course.evidence.recording import Recording
from course.grading.expect.probes import answered, expect_answer, expect_importable
from course.model.events import OutputLine, Probed, ProgramMissing
from course.model.feedback import Location
from tests.golden import golden

from .conftest import said, told

WHAT = "from theirs import f"


def probed(*answers: dict[str, Any], finished: bool = True) -> Recording:
    lines = tuple(json.dumps(answer) for answer in answers)
    return Recording("x", (OutputLine(0.1, "probe", "last words"), Probed(1.0, "probe", lines, finished)))


def error(question: str, text: str) -> dict[str, Any]:
    return {"question": question, "error": text, "file": "p/a.py", "line": 7}


def test_answers_that_are_right() -> None:
    recording = probed({"question": "sum", "value": 3, "type": "int"})
    assert said(expect_importable, recording, WHAT) is None
    assert said(expect_answer, recording, "sum", 3.0, "f(1, 2)", advice="") is None
    assert answered(recording, "sum", "f(1, 2)").type == "int"


@pytest.mark.parametrize(("value", "wanted"), [(4, 3), ("3", 3), (True, 1), (None, 3)])
def test_a_wrong_value_is_shown(value: object, wanted: object) -> None:
    recording = probed({"question": "sum", "value": value, "type": type(value).__name__})
    golden(
        told(expect_answer, recording, "sum", wanted, "f(1, 2)", advice="add", where=Location("p/a.py", 3))
    )


@pytest.mark.parametrize(
    "text",
    [
        "SyntaxError: invalid syntax",
        "TypeError: f() takes 0 positional arguments but 1 was given",
        "TypeError: f() got an unexpected keyword argument 'a'",
        "AttributeError: 'C' object has no attribute 'x'",
        "ValueError: no",
    ],
)
def test_an_exception_has_its_line_and_advice(text: str) -> None:
    golden(told(answered, probed(error("sum", text)), "sum", "f(1, 2)"))


def test_what_cannot_be_imported() -> None:
    recording = probed(error("", "ModuleNotFoundError: No module named 'theirs'"))
    assert WHAT in told(expect_importable, recording, WHAT).summary
    assert "could not be tested" in told(answered, recording, "sum", "f(1, 2)").summary


def test_what_hangs() -> None:
    golden(told(expect_importable, probed(finished=False), WHAT))
    later = probed({"question": "a", "value": 1, "type": "int"}, finished=False)
    assert said(expect_importable, later, WHAT) is None
    golden(told(answered, later, "sum", "f(1, 2)"))


def test_a_folder_that_is_not_there() -> None:
    looked_at = (HomeEntry("project", "folder"),)
    recording = Recording("x", (ProgramMissing(0.1, "probe", "projekt"),), looked_at=looked_at)
    assert "there is `~/project`" in told(expect_importable, recording, WHAT).summary


def test_a_probe_that_never_ran_is_our_fault() -> None:
    with pytest.raises(OurFault):
        expect_importable(Recording("x"), WHAT)


@pytest.mark.parametrize("value", [None, ["a", None], [1.5], {"a": 1.5}, "ab", [1.5, "b", 2]])
def test_an_answer_that_our_own_program_would_never_send(value: object) -> None:
    recording = probed({"question": "sum", "value": value, "type": "x"})
    place = Location("p/a.py", 3)
    failure = told(answered, recording, "sum", "f(1, 2)", shape=tuple[float, str], where=place)
    assert "`f(1, 2)` sends something unexpected" in failure.summary
    assert failure.where == (place,)


def test_an_answer_of_the_asked_shape_and_an_exception_instead_of_it() -> None:
    right = probed({"question": "sum", "value": [1, "b"], "type": "x"})
    assert said(answered, right, "sum", "f()", shape=tuple[float, str]) is None
    failed = probed(error("sum", "ValueError: no"))
    assert "`f()` fails" in told(answered, failed, "sum", "f()", shape=tuple[float, str]).summary
