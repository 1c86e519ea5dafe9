"""Nothing private leaks: control characters, paths, secrets, our own errors, right answers."""

from __future__ import annotations

import re

import pytest
from msgspec import to_builtins

from course.model import replace
from course.model.feedback import Feedback
from course.model.result import CheckResult, Outcome, Result, Verdict
from course.report.gradebook.cleaning import Cleaner, places_here
from tests.report.gradebook import hostile, samples

FORBIDDEN = re.compile(
    "[\x00-\x09\x0b-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069\u200f\ufeff\ufdd0\ufffe\uffff\ud800-\udfff]"
)
FAULT = Feedback("KeyError: 'the answer is 42' in /srv/grading", details=("Traceback", "/srv/grading/x.py"))


@pytest.mark.parametrize("text", hostile.TEXTS, ids=lambda text: ascii(text[:20]))
def test_no_control_path_or_secret_is_left_anywhere(text: str) -> None:
    told = str(to_builtins(hostile.sheet(text)))
    assert not FORBIDDEN.search(told)
    assert not re.search(r"/srv/grading(?!/machine-7/homes)", told), told
    assert hostile.SECRET not in told
    assert "evil.example\x1b" not in told
    assert len(told) < 100_000


def test_what_is_replaced_is_the_whole_path_and_nothing_more() -> None:
    cleaner = Cleaner({"/tmp/home": "~", "/tmp/home/lib": "[lib]"})
    shown = {
        "/tmp/home": "~",
        "/tmp/home/a.py:3": "~/a.py:3",
        "in /tmp/home.": "in ~.",
        '"/tmp/home"': '"~"',
        "A=/tmp/home:/x": "A=~:/x",
        "/tmp/home/lib/x": "[lib]/x",
        "-I/tmp/home/include": "-I~/include",
        "/tmp/homes": "/tmp/homes",
        "/tmp/home-2": "/tmp/home-2",
        "/tmp/home.bak": "/tmp/home.bak",
        "~/tmp/home": "~/tmp/home",
        "/tm\x1b[0mp/home": "~",
    }
    assert {text: cleaner.line(text) for text in shown} == shown


def test_a_path_is_replaced_before_the_text_is_cut() -> None:
    cleaner = Cleaner({"/srv/grading/home": "~"})
    assert "/srv" not in cleaner.line("x" * 235 + " /srv/grading/home/a.py")
    assert "/srv" not in "".join(cleaner.evidence(["x" * 235 + " /srv/grading/home/a.py"]))


def test_secrets_go_even_inside_words() -> None:
    assert Cleaner(secrets=("s3cret", "")).prose("xs3crety") == "x[hidden]y"


def test_cutting_says_how_much_is_missing_once() -> None:
    assert Cleaner().line("x" * 1_000_000).endswith("x... (999760 more characters)")
    assert Cleaner().prose("x" * 1_000_000).endswith("x... (999100 more characters)")
    assert Cleaner().evidence(["x" * 1_000_000])[0].endswith("x... (999760 more characters)")


def test_evidence_keeps_its_indentation_and_both_ends() -> None:
    lines = Cleaner().evidence(["  first", *("x" for _ in range(100)), "    last"])
    assert (lines[0], lines[-1]) == ("  first", "    last")
    assert "... 62 more lines ..." in lines


def test_long_lists_are_cut() -> None:
    sheet = hostile.sheet("text")
    result = sheet.marks[0].result
    assert result is not None and result.checks[1].feedback is not None
    assert len(result.checks[1].feedback.where) == 5
    assert len(sheet.remarks) == len(result.notes) == 20


def test_an_error_of_ours_tells_nothing_of_itself() -> None:
    check = CheckResult("a", "A", 1, Outcome.ERROR, feedback=FAULT)
    for result in (
        Result("x", Verdict.OUR_ERROR, (check,)),
        Result("x", Verdict.OUR_ERROR, fault=FAULT),
        Result("x", Verdict.NOT_AVAILABLE, fault=FAULT),
    ):
        told = str(to_builtins(Cleaner().result(result)))
        assert "42" not in told and "Traceback" not in told and "/srv" not in told
        assert "not the learner's failure" in told


def test_a_fault_is_told_once() -> None:
    check = CheckResult("a", "A", 1, Outcome.ERROR, feedback=FAULT)
    assert Cleaner().result(Result("x", Verdict.OUR_ERROR, (check,))).fault is None


def test_the_explanation_of_a_right_answer_is_an_answer() -> None:
    check = CheckResult("a", "A", 1, Outcome.PASSED, feedback=Feedback("Right, because it is 42."))
    assert Cleaner().result(Result("x", Verdict.PASSED, (check,))).checks[0].feedback is None


def test_points_outcomes_and_the_containment() -> None:
    before = replace(samples.result("plural"), containment="namespaces")
    after = Cleaner().result(before)
    assert (after.points, after.max_points, after.containment) == (before.points, before.max_points, "")
    assert [check.outcome for check in after.checks] == [check.outcome for check in before.checks]


def test_places_of_this_machine_are_whole_paths() -> None:
    assert all(path.startswith("/") and not path.endswith("/") for path in places_here())
    assert "[course]" in places_here().values()
