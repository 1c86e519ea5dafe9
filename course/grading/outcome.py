"""From how a check function ended to its result: passed, the learner's failure, or our error."""

from __future__ import annotations

import dataclasses
import traceback
from collections.abc import Iterable

from course.feedback import Failure, Feedback, NotApplicable, Spoilt
from course.grading.author import CheckSpec
from course.grading.result import CheckResult, Outcome

_TRACE_LINES = 12
# How feedback begins that a `Spoilt` recording leads to.
_SPOILT = "The recording is spoilt"


def passed(spec: CheckSpec) -> CheckResult:
    return CheckResult(spec.id, spec.title, spec.points, Outcome.PASSED, spec.bonus)


def skipped(spec: CheckSpec, because: str) -> CheckResult:
    return CheckResult(spec.id, spec.title, spec.points, Outcome.SKIPPED, spec.bonus, skipped_because=because)


def raised(spec: CheckSpec, error: BaseException) -> CheckResult:
    """Only a `Failure` is the learner's; `NotApplicable` is nobody's; anything else is our error."""
    if isinstance(error, NotApplicable):
        return dataclasses.replace(skipped(spec, error.because), outcome=Outcome.NOT_APPLICABLE)
    if isinstance(error, Failure):
        return CheckResult(spec.id, spec.title, spec.points, Outcome.FAILED, spec.bonus, error.feedback)
    return CheckResult(spec.id, spec.title, spec.points, Outcome.ERROR, spec.bonus, our_error(error))


def is_spoilt(checks: Iterable[CheckResult]) -> bool:
    """Whether another recording may be a better one."""
    errors = (check.feedback for check in checks if check.outcome is Outcome.ERROR)
    return any(feedback is not None and feedback.summary.startswith(_SPOILT) for feedback in errors)


def our_error(error: BaseException) -> Feedback:
    """Feedback for a fault of the course: never the learner's, does not count."""
    if isinstance(error, Spoilt):
        return Feedback(f"{_SPOILT}: {error}", advice="It is not your fault, and does not count. Try again.")
    lines = "".join(traceback.format_exception(error)).splitlines()
    return Feedback(
        summary=f"The grader itself failed here ({type(error).__name__}: {_first_line(error)}).",
        advice="This is the course's error, not yours. The attempt does not count.",
        details=tuple(lines[-_TRACE_LINES:]),
    )


def unmet(spec: CheckSpec, done: dict[str, CheckResult], titles: dict[str, str]) -> str | None:
    """Why this check cannot be judged: the first check it needs that did not pass."""
    for need in spec.needs:
        if done[need].outcome is not Outcome.PASSED:
            return f"needs «{titles[need]}»"
    return None


def out_of_reach(spec: CheckSpec, done: dict[str, CheckResult]) -> str | None:
    """Why this check is not applicable: one that it needs is not."""
    needed = (done[need] for need in spec.needs)
    return next((c.skipped_because for c in needed if c.outcome is Outcome.NOT_APPLICABLE), None)


def _first_line(error: BaseException) -> str:
    return (str(error).splitlines() or [""])[0]
