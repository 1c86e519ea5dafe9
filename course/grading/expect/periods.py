"""Expectations about how often something happens."""

from __future__ import annotations

from itertools import pairwise
from statistics import median

from course.evidence.recording import Recording
from course.evidence.topic_view import MIN_INTERVALS, TopicView, ask_for, hertz, seconds
from course.explain.observed import unproven
from course.explain.paces import at_once, pace_cause
from course.model.feedback import Failure, Feedback, Location


def expect_period(
    came: TopicView | tuple[float, ...],
    period: float,
    *,
    what: str | None = None,
    tolerance: float = 0.2,
    advice: str | None = None,
    where: tuple[Location, ...] = (),
    program: Recording | None = None,
    written: bool = True,
) -> None:
    """Check that the median of at least four intervals is `period` (s), within the fraction `tolerance`.

    came: the messages of a topic, whose pace a report can then plot; or the times of anything else (s, our
    clock). what: what to call them. program: the recording with only this program's sources, where the
    times may prove a cause. advice, where: used if they do not. written: whether the code itself must
    contain the period, rather than get it from elsewhere. Raises Failure with both periods.
    """
    if isinstance(came, TopicView):
        ask_for(came.name, period * (1 - tolerance), period * (1 + tolerance))
        times, what = came.times, what or f"messages on {came.name}"
    else:
        times, what = came, what or "times"
    intervals = [later - earlier for earlier, later in pairwise(times)]
    together = at_once(intervals, period)
    wrong = bool(intervals) and abs(median(intervals) - period) > tolerance * period
    if not wrong and together == 1 and len(intervals) >= MIN_INTERVALS:
        return
    cause = pace_cause(times, period, program.sources, written=written) if program else None
    if program and not cause and advice is None:
        cause = unproven(program, "the period of the timer, and what its callback does or waits for.")
    where, advice = (cause.where, cause.text) if cause else (where, advice)
    wanted = f"one every {seconds(period)}"
    if together > 1:
        summary = f"The {what} come {together} at a time, every {seconds(period)}."
        expected, seen = f"{wanted} ({hertz(period)})", f"{together} every {seconds(period)}"
    elif wrong:
        pace = median(intervals)
        summary = f"The {what} come every {seconds(pace)}, not every {seconds(period)}."
        expected, seen = f"{wanted} ({hertz(period)})", f"one every {seconds(pace)} ({hertz(pace)})"
    else:
        few = f"Too few {what} came to measure their rate: {len(times)}."
        summary = few if times else f"No {what} came."
        expected, seen = f"at least {MIN_INTERVALS + 1}, {wanted}", f"{len(times)}"
    raise Failure(Feedback(summary=summary, expected=expected, seen=seen, where=where, advice=advice))
