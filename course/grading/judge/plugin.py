"""Judges recordings with the checks of a grader module, in one pytest session.

pytest collects every `Grader` of a module as a separate node, and every check as a test
function below it. So checks may use fixtures, `-k` selects them, and reports name them. The
fixture `recording` gives a check what its exercise's scenario observed. One session judges any
number of recordings, each as if it were the only one: no fixture outlives its recording.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable, Iterator
from itertools import zip_longest
from pathlib import Path
from typing import Any

import pytest

from course.evidence.recording import Recording
from course.evidence.topic_view import paces_asked
from course.explain.limits import with_limit
from course.grading import outcomes
from course.grading.author import CheckSpec, Grader
from course.grading.protocol import Judgment
from course.model import replace
from course.model.feedback import Failure, Feedback, NotApplicable, Pace
from course.model.result import CheckResult, Doubt, Outcome

_FAULT_LINES = 12
_PYTEST = (
    # graders/conftest.py is for `pytest graders/`; no conftest may influence a grading.
    "--noconftest",
    *("-p", "no:cacheprovider", "-p", "no:faulthandler"),
    # They run the garbage collector several times, for warnings that we do not need.
    *("-p", "no:unraisableexception", "-p", "no:threadexception"),
    *("-q", "--tb=short", "--capture=no", "-W", "ignore"),
)


class CheckItem(pytest.Function):
    """One check as a pytest item."""

    def __init__(self, *, spec: CheckSpec, grader: Grader, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.spec = spec
        self.grader = grader
        self.pace: Pace | None = None

    def runtest(self) -> None:
        """A check's pace is the last one that it asks for."""
        self.pace = None
        with paces_asked() as paces:
            try:
                super().runtest()
            finally:
                self.pace = paces[-1] if paces else None

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        """If the learner's work is wrong, don't search the sources for a traceback."""
        if isinstance(excinfo.value, Failure):
            return f"{self.spec.exercise}: {self.spec.title}: {excinfo.value}"
        return super().repr_failure(excinfo)


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
    """Judges recordings with the checks of their exercises.

    exercises: ids of those whose checks are collected. recordings: taken one by one, each after the
    previous one has been judged. tell: gets their judgments in the same order.
    """

    def __init__(
        self,
        exercises: Collection[str],
        recordings: Iterable[Recording],
        tell: Callable[[Judgment], None],
    ) -> None:
        self._exercises = exercises
        self._waiting = iter(recordings)
        self._tell = tell
        self._faults: list[str] = []
        self._recording: Recording | None = None
        self._results: dict[str, CheckResult] = {}

    def finish(self) -> None:
        """Report the recordings that pytest did not finish; those without any result get a fault."""
        if self._recording is not None:
            self._end(self._recording)
        for recording in self._waiting:
            self._results = {}
            self._end(recording)

    @pytest.hookimpl(tryfirst=True)
    def pytest_pycollect_makeitem(
        self, collector: pytest.Collector, obj: object
    ) -> list[pytest.Collector] | None:
        if not isinstance(obj, Grader):
            return None
        if obj.exercise not in self._exercises:
            return []
        return [GraderNode.from_parent(collector, name=obj.exercise, grader=obj)]

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        if report.failed:
            self._faults.append(str(report.longrepr))

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        """Replaces pytest's own loop, which runs the checks only once."""
        checks = [item for item in session.items if isinstance(item, CheckItem)]
        for recording in self._waiting:
            self._recording, self._results = recording, {}
            own = [item for item in checks if item.spec.exercise == recording.exercise and not self._faults]
            for item, following in zip_longest(own, own[1:]):
                item.ihook.pytest_runtest_protocol(item=item, nextitem=following)
            self._end(recording)
        return True

    def _end(self, recording: Recording) -> None:
        fault = None
        if self._faults or not self._results:
            lines = "\n".join(self._faults).splitlines()
            summary = f"The grader of {recording.exercise} cannot be run."
            fault = Feedback(summary=summary, details=tuple(lines[-_FAULT_LINES:]))
        self._recording = None
        checks = tuple(self._results.values())
        lost = recording.killed and any(check.outcome is Outcome.FAILED for check in checks)
        self._tell(Judgment(checks, fault, Doubt.KILLED if lost else None))

    @pytest.fixture
    def recording(self) -> Recording:
        """What the exercise's scenario observed."""
        assert self._recording is not None
        return self._recording

    def pytest_runtest_setup(self, item: pytest.Item) -> None:
        if isinstance(item, CheckItem):
            titles = {spec.id: spec.title for spec in item.grader.checks.values()}
            without = outcomes.out_of_reach(item.spec, self._results)
            if without:
                raise NotApplicable(without)
            because = outcomes.unmet(item.spec, self._results, titles)
            if because:
                pytest.skip(because)

    def pytest_runtest_makereport(self, item: pytest.Item, call: pytest.CallInfo[None]) -> None:
        if not isinstance(item, CheckItem):
            return
        known = self._results.get(item.spec.id)
        if known is None or known.outcome is Outcome.PASSED:
            result = _result(item.spec, call)
            if result is not None and self._recording is not None:
                limited = with_limit(result, self._recording.limit_reached)
                doubted = outcomes.doubted(limited, self._recording)
                self._results[item.spec.id] = replace(doubted, pace=item.pace)


def _result(spec: CheckSpec, call: pytest.CallInfo[None]) -> CheckResult | None:
    """The result after this phase (setup, call, or teardown); None if the phase decides nothing."""
    if call.excinfo is None:
        return outcomes.passed(spec) if call.when == "call" else None
    error = call.excinfo.value
    if isinstance(error, pytest.skip.Exception):
        return outcomes.skipped(spec, error.msg or "skipped")
    return outcomes.raised(spec, error)


def judge(
    grader: Path,
    exercises: Collection[str],
    recordings: Iterable[Recording],
    tell: Callable[[Judgment], None],
    over: Callable[[], None] = lambda: None,
) -> None:
    """Judge recordings of these exercises in one pytest session. Needs no ROS.

    grader: the module with the checks of all of them. recordings: each is taken after the previous one has
    been judged, so that they are not all in memory. tell: gets one judgment for each, in order; with a
    fault if the grader cannot be run. over: called when pytest has ended; recordings that it did not reach
    are reported with a fault after that. pytest writes its progress to standard output.
    """
    plugin = JudgePlugin(exercises, recordings, tell)
    pytest.main([str(grader), f"--rootdir={grader.parent}", "-c", os.devnull, *_PYTEST], [plugin])
    over()
    plugin.finish()
