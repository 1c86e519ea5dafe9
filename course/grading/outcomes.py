"""Turns the way a check function ended into its result: passed, the learner's failure, or our error."""

from __future__ import annotations

import traceback
from collections.abc import Iterator
from pathlib import Path

from course.content.layout import GRADERS
from course.errors import OurFault
from course.evidence.recording import Recording
from course.grading.author import CheckSpec
from course.model import replace
from course.model.events import Probed
from course.model.feedback import DoubtfulFailure, Failure, Feedback, Location, NotApplicable, Spoilt, TooBusy
from course.model.result import CheckResult, Doubt, Outcome

_TRACE_LINES = 12


def passed(spec: CheckSpec) -> CheckResult:
    return CheckResult(spec.id, spec.title, spec.points, Outcome.PASSED, spec.bonus)


def failed(spec: CheckSpec, feedback: Feedback) -> CheckResult:
    return CheckResult(spec.id, spec.title, spec.points, Outcome.FAILED, spec.bonus, feedback)


def skipped(spec: CheckSpec, because: str) -> CheckResult:
    return CheckResult(spec.id, spec.title, spec.points, Outcome.SKIPPED, spec.bonus, skipped_because=because)


def raised(spec: CheckSpec, error: BaseException) -> CheckResult:
    """Only a `Failure` is the learner's fault; `NotApplicable` is nobody's; anything else is our error."""
    if isinstance(error, NotApplicable):
        return replace(skipped(spec, error.because), outcome=Outcome.NOT_APPLICABLE)
    if isinstance(error, Failure):
        doubt = Doubt.KILLED if isinstance(error, DoubtfulFailure) else None
        return replace(failed(spec, error.feedback), doubt=doubt)
    return CheckResult(
        spec.id,
        spec.title,
        spec.points,
        Outcome.ERROR,
        spec.bonus,
        our_error(error),
        doubt=doubt_about(error),
    )


def doubt_about(error: BaseException) -> Doubt | None:
    """Why this error may not occur in another attempt; None if nothing suggests that."""
    if isinstance(error, TooBusy):
        return Doubt.BUSY
    # An OurFault means that there is nothing to judge: the submission may have prevented it.
    return Doubt.SPOILT if isinstance(error, Spoilt | OurFault | MemoryError) else None


def doubted(result: CheckResult, recording: Recording) -> CheckResult:
    """Add doubt to an error if the learner's code answered a probe, because it can send anything."""
    probed = any(isinstance(event, Probed) for event in recording.events)
    is_bug = result.outcome is Outcome.ERROR and result.doubt is None
    return replace(result, doubt=Doubt.SPOILT) if is_bug and probed else result


def our_error(error: BaseException) -> Feedback:
    """Feedback on an error of the course, which is never the learner's fault and does not count."""
    if isinstance(error, Spoilt):
        return Feedback(str(error), advice="This attempt does not count. Try again.")
    lines = "".join(traceback.format_exception(error)).splitlines()
    return Feedback(
        summary=f"The grader itself failed here ({type(error).__name__}: {_first_line(error)}).",
        where=tuple(_in_graders(error)),
        advice="This is the course's error, not yours. The attempt does not count.",
        details=tuple(lines[-_TRACE_LINES:]),
    )


def _in_graders(error: BaseException) -> Iterator[Location]:
    """The innermost line of a grader that led to the error."""
    frames = traceback.extract_tb(error.__traceback__)
    own = [frame for frame in frames if GRADERS in Path(frame.filename).parts]
    if own:
        yield Location(own[-1].filename, own[-1].lineno)


def unmet(spec: CheckSpec, done: dict[str, CheckResult], titles: dict[str, str]) -> str | None:
    """Why this check cannot be judged: the first check it needs that did not pass."""
    for need in spec.needs:
        if done[need].outcome is not Outcome.PASSED:
            return f'needs "{titles[need]}"'
    return None


def out_of_reach(spec: CheckSpec, done: dict[str, CheckResult]) -> str | None:
    """Why this check is not applicable: one that it needs is not applicable either."""
    needed = (done[need] for need in spec.needs)
    return next((c.skipped_because for c in needed if c.outcome is Outcome.NOT_APPLICABLE), None)


def _first_line(error: BaseException) -> str:
    return (str(error).splitlines() or [""])[0]
