"""When a machine was too busy to mark anything as wrong."""

from __future__ import annotations

import pytest

from course.grading.disturbed import is_doubtful
from course.grading.result import Result, Timing, Verdict


def doubtful(verdict: Verdict = Verdict.NOT_PASSED, *, evidence: float = 2.0, lag: float, cpu: float) -> bool:
    return is_doubtful(Result("04-light", verdict, timing=Timing(evidence=evidence, lag=lag, cpu=cpu)))


def test_who_had_to_wait_for_a_processor_cannot_tell() -> None:
    assert doubtful(lag=0.3, cpu=0.2)
    assert not doubtful(lag=0.05, cpu=0.2)


@pytest.mark.parametrize(("evidence", "cpu", "own"), [(2.0, 0.9, False), (2.0, 1.1, True), (0.1, 0.2, False)])
def test_a_submission_may_keep_the_machine_busy_itself(evidence: float, cpu: float, own: bool) -> None:
    assert doubtful(evidence=evidence, lag=0.3, cpu=cpu) is not own


def test_what_passed_has_passed() -> None:
    assert not doubtful(Verdict.PASSED, lag=0.3, cpu=0.2)
