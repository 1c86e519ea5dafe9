"""Findings for programs, by their readers' rules."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from datetime import datetime, timezone

from course.report.gradebook.github import MOST
from course.report.validation import Note, ProofCase, annotated, as_junit
from tests.report.gradebook.test_junit import assert_counts, assert_suite

BEGAN = datetime(2026, 1, 2, tzinfo=timezone.utc)
NOTE = Note("chapters/a.yaml", 7, "It is not caught: 50%", "correct it", "04-light")


def test_a_suite_for_each_exercise_and_one_for_the_files() -> None:
    cases = [
        ProofCase("04-light", "mistake dark", 2.0, [NOTE]),
        ProofCase("04-dim", "solution", 1.0),
        ProofCase("04-light", "solution", 3.0, skipped="There is no ROS."),
    ]
    root = ET.fromstring("".join(as_junit("proofs", BEGAN, cases, [NOTE])))
    assert_counts(root)
    for suite in root:
        assert_suite(suite)
    counts = {
        suite.get("name"): [suite.get(name) for name in ("tests", "failures", "skipped")] for suite in root
    }
    assert counts == {"files": ["1", "1", "0"], "04-dim": ["1", "0", "0"], "04-light": ["2", "1", "1"]}
    failed = next(case for case in root.iter("testcase") if case.get("name") == "mistake dark")
    assert (failed.get("file"), failed.get("line")) == ("chapters/a.yaml", "7")
    assert "try       correct it" in (failed[0].text or "")


def test_files_without_findings_are_a_case_that_passed() -> None:
    root = ET.fromstring("".join(as_junit("proofs", BEGAN, [], [])))
    assert (root.get("tests"), root.get("failures")) == ("1", "0")


def test_what_has_a_line_is_annotated_first_and_no_more_than_is_shown() -> None:
    vague = Note("b.yaml", None, "It is wrong.", None)
    made = annotated([vague, *[NOTE] * 3])
    assert made[0] == (
        "::error title=04-light,file=chapters/a.yaml,line=7::It is not caught: 50%25 correct it"
    )
    assert made[-1] == "::error title=course,file=b.yaml::It is wrong."
    assert len(annotated([NOTE] * 20)) == MOST
