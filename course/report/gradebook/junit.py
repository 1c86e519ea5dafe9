"""JUnit XML, as CI services read it. For a class: a suite for each submission, a case for each check.

There is no standard, only readers. Some need `classname`, some show the element's text instead of its
`message`, and some mix up cases with the same name. So every case has all three, and a unique name.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from datetime import datetime, timezone

from course.model import replace
from course.model.result import CheckResult, Feedback, Outcome
from course.report.console import number
from course.report.gradebook.check_words import NOTHING, comments, text_of, why
from course.report.gradebook.sheets import Mark, Names, Sheet

_KINDS = {
    Outcome.FAILED: "failure",
    Outcome.ERROR: "error",
    Outcome.SKIPPED: "skipped",
    Outcome.NOT_APPLICABLE: "skipped",
}


@dataclass(frozen=True)
class Case:
    """One test case. kind: None if it passed, else the name of its child element."""

    exercise: str
    name: str
    kind: str | None = None
    type: str = ""
    feedback: Feedback | None = None
    seconds: float = 0.0


@dataclass(frozen=True)
class Suite:
    """Cases that belong together. properties: names with their texts; a name may come more than once."""

    name: str
    cases: tuple[Case, ...]
    properties: tuple[tuple[str, str], ...] = ()


@dataclass
class Totals:
    """The root element's counts over all suites."""

    tests: int = 0
    failures: int = 0
    errors: int = 0
    skipped: int = 0
    seconds: float = 0.0

    def add(self, cases: Iterable[Case]) -> Totals:
        for case in cases:
            self.tests += 1
            self.failures += case.kind == "failure"
            self.errors += case.kind == "error"
            self.skipped += case.kind == "skipped"
            self.seconds += case.seconds
        return self

    def attributes(self) -> dict[str, str]:
        counts = {name: str(getattr(self, name)) for name in ("tests", "failures", "errors", "skipped")}
        return {**counts, "time": f"{self.seconds:.3f}"}


def pieces(name: str, began: datetime, walk: Callable[[], Iterable[Sheet]]) -> Iterator[str]:
    """A class as a document, one submission at a time; `walk` is called twice."""
    return document(name, began, lambda: map(_of_sheet, walk()))


def document(name: str, began: datetime, walk: Callable[[], Iterable[Suite]]) -> Iterator[str]:
    """The document, one suite at a time. `walk` is called twice: the root's counts come before the suites."""
    counts = Totals()
    for suite in walk():
        counts.add(suite.cases)
    root = ET.Element("testsuites", {"name": name, **counts.attributes()})
    yield '<?xml version="1.0" encoding="UTF-8"?>\n'
    yield ET.tostring(root, encoding="unicode").removesuffix(" />") + ">\n"
    names = Names()
    for suite in walk():
        yield _suite(replace(suite, name=names.unique(suite.name)), began)
    yield "</testsuites>\n"


def cases(sheet: Sheet) -> Iterator[Case]:
    """All cases of a submission. The first case of each exercise gets the exercise's time."""
    for mark in sheet.marks:
        first, *others = _of_mark(mark)
        yield replace(first, seconds=mark.seconds)
        yield from others


def _of_mark(mark: Mark) -> Iterator[Case]:
    exercise, result = mark.exercise.id, mark.result
    if result is None:
        yield Case(exercise, exercise, "failure", mark.verdict, Feedback(NOTHING))
        return
    if result.fault:
        yield Case(exercise, exercise, "error", mark.verdict, result.fault)
    elif not result.checks:
        why_not = Feedback(" ".join(result.notes) or "It does not apply here.")
        yield Case(exercise, exercise, "skipped", mark.verdict, why_not)
    yield from (_of_check(exercise, check) for check in result.checks)


def _of_check(exercise: str, check: CheckResult) -> Case:
    name = f"{exercise}/{check.id}: {check.title}"
    return Case(exercise, name, _KINDS.get(check.outcome), check.outcome.value, why(check))


def _of_sheet(sheet: Sheet) -> Suite:
    return Suite(sheet.person.id or "nameless", tuple(cases(sheet)), tuple(_properties(sheet)))


def _suite(suite: Suite, began: datetime) -> str:
    stamp = began.astimezone(timezone.utc).strftime("%Y-%m-%dT%H:%M:%S")
    counts = Totals().add(suite.cases).attributes()
    element = ET.Element("testsuite", {"name": suite.name, **counts, "timestamp": stamp})
    properties = ET.SubElement(element, "properties")
    for key, value in suite.properties:
        ET.SubElement(properties, "property", {"name": key, "value": value})
    names = Names()
    # A dot in a class name begins a new level in several readers.
    group = suite.name.replace(".", "_")
    for case in suite.cases:
        _append(element, replace(case, name=names.unique(case.name)), group)
    ET.indent(element, level=1)
    return f"  {ET.tostring(element, encoding='unicode')}\n"


def _properties(sheet: Sheet) -> Iterator[tuple[str, str]]:
    told = (("name", sheet.person.name), ("source", sheet.source), ("state", sheet.state))
    points = (("points", sheet.points), ("max_points", sheet.max_points))
    yield from ((key, value) for key, value in told if value)
    yield from ((key, number(value)) for key, value in points if value is not None)
    yield from (("by_hand", said) for said in comments(sheet))
    yield from (("remark", remark) for remark in sheet.remarks)


def _append(suite: ET.Element, case: Case, group: str) -> None:
    attributes = {
        "classname": f"{group}.{case.exercise}",
        "name": case.name,
        "time": f"{case.seconds:.3f}",
    }
    place = case.feedback.where[0] if case.feedback and case.feedback.where else None
    if place:
        attributes["file"] = place.file
    if place and place.line:
        attributes["line"] = str(place.line)
    element = ET.SubElement(suite, "testcase", attributes)
    if case.kind and case.feedback:
        child = ET.SubElement(element, case.kind, {"message": case.feedback.summary, "type": case.type})
        child.text = text_of(case.feedback)
