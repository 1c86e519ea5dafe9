"""Why something happens at the wrong pace, from the times when it happened and code that matches them."""

from __future__ import annotations

import ast
from collections.abc import Sequence
from itertools import pairwise
from statistics import median

from course.evidence.sources import Sources
from course.explain.callbacks import callbacks, in_callbacks
from course.explain.cpp_code import cpp_files
from course.explain.cpp_timers import cpp_periods, integer_division, rate_unused
from course.explain.engine import Cause
from course.explain.python_code import called_name, calls, nodes, number, number_where
from course.explain.python_slips import (
    first,
    long_sleep,
    loop_without_sleep,
    never_again,
    several_timers,
    waits_for_input,
)
from course.model.feedback import Location

_NEAR = 0.25
_UNITS = ((1e3, "milliseconds"), (1e6, "microseconds"))
_TOGETHER = 0.15  # of a period: events this close belong together


def pace_cause(times: Sequence[float], period: float, sources: Sources, *, written: bool) -> Cause | None:
    """The cause of a pace other than `period` (s), if the times (s) and the code prove one.

    written: whether the code must state the period; otherwise another number is not a mistake.
    """
    gaps = [later - earlier for earlier, later in pairwise(times)]
    if not gaps:
        return waits_for_input(sources) or (never_again(sources) if calls(sources, "spin") else None)
    if cpp_files(sources):
        fast = median(gaps) < period / 10
        found = first(sources, integer_division, rate_unused) if fast else None
    else:
        causes = (_looped, _rushed, _several_at_once, _inverted)
        found = next((one for cause in causes if (one := cause(gaps, period, sources))), None)
        found = found or _slept(gaps, sources)
    return found or (_written(gaps, period, sources) if written else None)


def at_once(gaps: Sequence[float], period: float) -> int:
    """How many events come together in each `period`: 2 for two timers with the same period; normally 1.

    Events before the first pause do not count, because the log delivers them all at once.
    """
    pauses = [number for number, gap in enumerate(gaps) if gap > _TOGETHER * period]
    sizes = [later - earlier for earlier, later in pairwise(pauses)]
    if len(set(sizes)) != 1:
        return 1
    whole = sum(gaps[pauses[0] : pauses[-1]]) / len(sizes)
    return sizes[0] if _near(whole, period) else 1


def _near(value: float, wanted: float) -> bool:
    return abs(value - wanted) <= _NEAR * wanted


def _several_at_once(gaps: Sequence[float], period: float, sources: Sources) -> Cause | None:
    count, timers = at_once(gaps, period), several_timers(sources)
    if count == 1 and timers:  # a busy machine may keep them apart
        count = round(len(gaps) * period / sum(gaps))
    if count < 2:
        return None
    if timers:
        return Cause(f"{count} come at once, every {period:g} s. {timers.text}", timers.where)
    for name in ("publish", "info", "call_async"):
        inside = in_callbacks(sources, name)
        if len(inside) >= count:
            what = f"{count} come at once, every {period:g} s. Call `{name}` only once in the callback."
            return Cause(what, inside[:2])
    return _prints(sources, count, period)


def _prints(sources: Sources, count: int, period: float) -> Cause | None:
    """A loop that prints `count` times in each pass."""
    for file, loop in nodes(sources):
        inside = list(ast.walk(loop)) if isinstance(loop, ast.While) else []
        lines = [
            part.lineno for part in inside if isinstance(part, ast.Call) and called_name(part) == "print"
        ]
        if len(lines) == count:
            where = tuple(Location(file, line) for line in lines[:2])
            what = f"{count} come at once, every {period:g} s. Print only once per pass through the loop."
            return Cause(what, where)
    return None


def _looped(gaps: Sequence[float], period: float, sources: Sources) -> Cause | None:
    """A `while` in a callback that logs, publishes, or calls as fast as it can."""
    if median(gaps) > period / 10:
        return None
    for callback in callbacks(sources):
        for loop in (part for part in ast.walk(callback.node) if isinstance(part, ast.While)):
            inside = {called_name(part) for part in ast.walk(loop) if isinstance(part, ast.Call)}
            if inside & {"info", "publish", "call_async"} and "sleep" not in inside:
                text = "This loop keeps a single call of the callback from ending. Remove it: the timer "
                text += "already calls the function again and again."
                return Cause(text, (Location(callback.file, loop.lineno),))
    return None


def _rushed(gaps: Sequence[float], period: float, sources: Sources) -> Cause | None:
    return loop_without_sleep(sources) if median(gaps) < period / 10 else None


def _inverted(gaps: Sequence[float], period: float, sources: Sources) -> Cause | None:
    """`create_timer(1 / period, ...)`, where the times are those of the quotient."""
    for timer in calls(sources, "create_timer"):
        given = timer.argument(0, "timer_period_sec")
        if isinstance(given, ast.BinOp) and isinstance(given.op, ast.Div) and _near(median(gaps), 1 / period):
            text = f"`{ast.unparse(given)}` is {1 / period:g} here. A timer takes the period itself."
            return Cause(text, (timer.where,))
    return None


def _slept(gaps: Sequence[float], sources: Sources) -> Cause | None:
    """A callback that sleeps longer than its period determines the pace."""
    seen = median(gaps)
    found = long_sleep(sources, at_least=0.3 * seen)
    return found if found and not long_sleep(sources, at_least=1.2 * seen) else None


def _written(gaps: Sequence[float], period: float, sources: Sources) -> Cause | None:
    """A timer whose period in the code is wrong, and matches what was seen.

    What is logged before anything listens arrives all at once, so a fast timer may look even faster.
    """
    seen = median(gaps)
    for value, where in _periods(sources):
        like_seen = value / 2 < seen < (1 + _NEAR) * value
        if not _near(value, period) and (like_seen or max(value, seen) < period / 10):
            return Cause(_on(value, period), where)
    return None


def _periods(sources: Sources) -> list[tuple[float, tuple[Location, ...]]]:
    """The timers' periods in seconds, each with the line of the number and then the timer's."""
    if cpp_files(sources):
        return [(value, (where,)) for value, where in cpp_periods(sources)]
    timers = ((timer, timer.argument(0, "timer_period_sec")) for timer in calls(sources, "create_timer"))
    found = ((number(sources, arg), (*number_where(sources, arg), timer.where)) for timer, arg in timers)
    return [(value, where) for value, where in found if value is not None]


def _on(value: float, period: float) -> str:
    for factor, unit in _UNITS:
        if _near(value, period * factor) or _near(value, period / factor):
            return f"The period of a timer is in seconds, not in {unit}: {value:g} should be {period:g}."
    if _near(value, 1 / period):
        return f"{value:g} is calls per second. The period is the time between two calls: {period:g} s."
    return f"The timer's period is {value:g} s: change it to {period:g} s."
