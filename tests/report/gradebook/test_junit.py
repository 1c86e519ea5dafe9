"""JUnit XML by the rules that its readers have."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator

import pytest

from course.model import replace
from course.model.gradebook import GradedSubmission, Person
from course.report.gradebook import junit
from course.report.gradebook.sheets import Sheet, sheets
from tests.report.gradebook import hostile, samples

COUNTS = ("tests", "failures", "errors", "skipped")


def text_of(*graded: GradedSubmission) -> str:
    def walk() -> Iterator[Sheet]:
        return sheets(samples.gradebook(*graded), hostile.CLEANER)

    return "".join(junit.pieces("a <class>", samples.BEGAN, walk))


def read(*graded: GradedSubmission) -> ET.Element:
    """The root, after a look at everything that a reader relies on."""
    text = text_of(*graded)
    text.encode("utf-8")
    assert not re.search("[\x00-\x08\x0b-\x1f\ufffe\uffff\ud800-\udfff]", text)
    root = ET.fromstring(text)
    assert root.tag == "testsuites"
    assert_counts(root)
    names = [suite.get("name") for suite in root]
    assert len(set(names)) == len(names)
    for suite in root:
        assert_suite(suite)
    return root


def assert_suite(suite: ET.Element) -> None:
    assert suite.tag == "testsuite" and suite.get("name")
    assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d", suite.get("timestamp", ""))
    assert_counts(suite)
    cases = suite.findall("testcase")
    names = [case.get("name") for case in cases]
    assert len(set(names)) == len(names) > 0
    for case in cases:
        assert case.get("classname") and float(case.get("time", "")) >= 0
        assert int(case.get("line", "1")) > 0
        for child in case:
            assert child.tag in ("failure", "error", "skipped")
            assert child.get("type")
            assert (child.text or "").startswith(child.get("message", "?"))


def assert_counts(element: ET.Element) -> None:
    cases = list(element.iter("testcase"))
    found = [len(cases), *(sum(case.find(tag) is not None for case in cases) for tag in KINDS)]
    assert [int(element.get(name, "-1")) for name in COUNTS] == found
    seconds = sum(float(case.get("time", "nan")) for case in cases)
    assert float(element.get("time", "nan")) == pytest.approx(seconds, abs=0.01)


KINDS = ("failure", "error", "skipped")


def test_a_class_by_the_rules() -> None:
    root = read(*samples.CLASS.graded)
    assert [suite.get("name") for suite in root] == ["ada", "bao", "carl", "dilara", "emre"]
    assert [int(suite.get("errors", "")) for suite in root] == [0, 0, 0, 1, 0]
    assert root.get("name") == "a <class>"


def test_a_failure_tells_all_in_its_text() -> None:
    failure = read(samples.BAO).find(".//failure")
    assert failure is not None and failure.text is not None
    assert "expected  /amazing_quote\nseen      /amazing_quotes\nin        ros2_" in failure.text
    assert "try       Spell" in failure.text


def test_a_case_names_its_file_and_line() -> None:
    case = next(case for case in read(samples.BAO).iter("testcase") if case.find("failure") is not None)
    assert str(case.get("file")).endswith("_node.py") and case.get("line") == "21"
    assert case.get("classname") == "bao.18-publisher"
    assert case.get("name") == "18-publisher/topic_exists: it has a publisher on /amazing_quote"


def test_our_error_is_an_error_and_no_failure() -> None:
    (suite,) = read(samples.DILARA)
    assert (suite.get("failures"), suite.get("errors")) == ("0", "1")
    assert "60 s" not in text_of(samples.DILARA), "what went wrong on our side is not told"


def test_nothing_handed_in_is_a_failure() -> None:
    (suite,) = read(samples.EMRE)
    assert (suite.get("failures"), suite.get("tests")) == ("1", "1")


def test_points_are_properties() -> None:
    (suite,) = read(samples.CARL)
    found = [(item.get("name"), item.get("value")) for item in suite.iter("property")]
    assert ("points", "1") in found and ("max_points", "5") in found
    assert ("remark", "Handed in twice; the last one counts.") in found


def test_a_dot_in_an_id_is_no_level_of_the_class() -> None:
    case = next(read(replace(samples.ADA, person=Person("a.b"))).iter("testcase"))
    assert case.get("classname") == "a_b.18-publisher"


def test_two_of_one_name_are_two_suites() -> None:
    root = read(samples.ADA, samples.ADA, replace(samples.ADA, source="x"))
    assert [suite.get("name") for suite in root] == ["ada", "ada (2)", "ada (3)"]


@pytest.mark.parametrize("text", hostile.TEXTS, ids=lambda text: ascii(text[:20]))
def test_hostile_texts(text: str) -> None:
    (suite,) = read(hostile.graded(text))
    assert suite.get("tests") == "6"
    assert [suite.get(name) for name in ("failures", "errors", "skipped")] == ["1", "1", "2"]
