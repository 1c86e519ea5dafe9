"""The pytest plugin that runs grader modules.

pytest collects every `Grader` of a module as a node of its own and every check as a test
function below it, so checks may use fixtures, `-k` picks them, and reports name them. The
fixture `recording` gives a check what its exercise's scenario observed.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from course.evidence.recording import Recording
from course.grading import outcome
from course.grading.author import CheckSpec, Grader
from course.grading.result import CheckResult, Outcome


class CheckItem(pytest.Function):
    """One check as a pytest item."""

    def __init__(self, *, spec: CheckSpec, grader: Grader, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.spec = spec
        self.grader = grader


class GraderNode(pytest.Collector):
    """All checks of one exercise, in the order in which they were written."""

    def __init__(self, *, grader: Grader, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.grader = grader

    def collect(self) -> Iterator[pytest.Item]:
        for spec in self.grader.checks.values():
            function = self.grader.functions[spec.id]
            yield CheckItem.from_parent(
                self,
                name=spec.id,
                callobj=function,
                spec=spec,
                grader=self.grader,
                originalname=function.__name__,
            )


class JudgePlugin:
    """Judges a recording with the checks of its exercise.

    results: filled while pytest runs. faults: what kept it from judging at all.
    """

    def __init__(self, recording: Recording) -> None:
        self.exercise = recording.exercise
        self.results: dict[str, CheckResult] = {}
        self.faults: list[str] = []
        self._recording = recording

    @pytest.hookimpl(tryfirst=True)
    def pytest_pycollect_makeitem(
        self, collector: pytest.Collector, obj: object
    ) -> list[pytest.Collector] | None:
        if not isinstance(obj, Grader):
            return None
        if obj.exercise != self.exercise:
            return []
        return [GraderNode.from_parent(collector, name=obj.exercise, grader=obj)]

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        if report.failed:
            self.faults.append(str(report.longrepr))

    @pytest.fixture
    def recording(self) -> Recording:
        """What the exercise's scenario observed."""
        return self._recording

    def pytest_runtest_setup(self, item: pytest.Item) -> None:
        if isinstance(item, CheckItem):
            titles = {spec.id: spec.title for spec in item.grader.checks.values()}
            because = outcome.unmet(item.spec, self.results, titles)
            if because:
                pytest.skip(because)

    def pytest_runtest_makereport(self, item: pytest.Item, call: pytest.CallInfo[None]) -> None:
        if not isinstance(item, CheckItem):
            return
        known = self.results.get(item.spec.id)
        if known is None or known.outcome is Outcome.PASSED:
            result = _result(item.spec, call)
            if result is not None:
                self.results[item.spec.id] = result


def _result(spec: CheckSpec, call: pytest.CallInfo[None]) -> CheckResult | None:
    """What this phase (setup, call or teardown) means for the check; None when it says nothing."""
    if call.excinfo is None:
        return outcome.passed(spec) if call.when == "call" else None
    error = call.excinfo.value
    if isinstance(error, pytest.skip.Exception):
        return outcome.skipped(spec, error.msg or "skipped")
    return outcome.raised(spec, error)
