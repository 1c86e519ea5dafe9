"""The pytest plugin that runs grader modules.

pytest collects every `Grader` of a module as a node of its own and every check as a test
function below it, so checks may use fixtures, `-k` picks them, and reports name them. The
fixture `recording` gives a check what its exercise's scenario observed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import pytest

from course.evidence.recording import Recording
from course.grading import outcome
from course.grading.author import CheckSpec, Grader
from course.grading.result import CheckResult, Outcome

Provide = Callable[[Grader], Recording]


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
    """Judges the exercise `exercise`; `provide` makes its recording, once.

    results: filled while pytest runs. faults: what kept it from judging at all.
    """

    def __init__(self, exercise: str, provide: Provide) -> None:
        self.exercise = exercise
        self.results: dict[str, CheckResult] = {}
        self.faults: list[str] = []
        self.scenario_error: BaseException | None = None
        self._provide = provide
        self._recording: Recording | None = None

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

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session: pytest.Session) -> None:
        """Run the scenario once, before the first check."""
        graders = {item.grader.exercise: item.grader for item in session.items if isinstance(item, CheckItem)}
        for grader in graders.values():
            try:
                self._recording = self._provide(grader)
            except Exception as error:  # noqa: BLE001 - whatever a scenario ran into is our error, kept and shown
                self.scenario_error = error
                session.items.clear()

    @pytest.fixture
    def recording(self) -> Recording:
        """What the exercise's scenario observed."""
        assert self._recording is not None
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
