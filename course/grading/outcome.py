"""From how a check function ended to its result: passed, the learner's failure, or our error."""

from __future__ import annotations

import traceback

from course.feedback import Failure, Feedback
from course.grading.author import CheckSpec
from course.grading.result import CheckResult, Outcome

_TRACE_LINES = 12


def passed(spec: CheckSpec) -> CheckResult:
    return CheckResult(spec.id, spec.title, spec.points, Outcome.PASSED, spec.bonus)


def skipped(spec: CheckSpec, because: str) -> CheckResult:
    return CheckResult(spec.id, spec.title, spec.points, Outcome.SKIPPED, spec.bonus, skipped_because=because)


def raised(spec: CheckSpec, error: BaseException) -> CheckResult:
    """Only a `Failure` is the learner's; anything else that a check raises is our error."""
    if isinstance(error, Failure):
        return CheckResult(spec.id, spec.title, spec.points, Outcome.FAILED, spec.bonus, error.feedback)
    return CheckResult(spec.id, spec.title, spec.points, Outcome.ERROR, spec.bonus, our_error(error))


def our_error(error: BaseException) -> Feedback:
    """Feedback for a fault of the course: never the learner's, does not count."""
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


def _first_line(error: BaseException) -> str:
    return (str(error).splitlines() or [""])[0]
