"""What is usually wrong when a timer's callback does not do what it should."""

from __future__ import annotations

import ast
from dataclasses import dataclass

from course.evidence.sources import Sources
from course.feedback import Location
from course.grading.explain.python_code import calls, number

_LONG = 10.0


@dataclass(frozen=True)
class Cause:
    """A likely cause: what to say, and where it stands."""

    text: str
    where: tuple[Location, ...] = ()


def timer_cause(sources: Sources) -> Cause | None:
    """Why no callback comes: no timer, a callback that is called, or milliseconds for seconds."""
    timers = calls(sources, "create_timer")
    if not timers:
        return Cause(
            "No timer is made anywhere: `self.create_timer(0.5, self.timer_callback)` in `__init__`."
        )
    return called_callback(sources) or long_period(sources)


def called_callback(sources: Sources) -> Cause | None:
    """`self.timer_callback()` handed over where `self.timer_callback` belongs."""
    for timer in calls(sources, "create_timer"):
        callback = timer.argument(1, "callback")
        if isinstance(callback, ast.Call) and not _makes_a_callable(callback):
            written = ast.unparse(callback)
            return Cause(
                f"`{written}` calls the function at once and hands over its result, `None`. "
                f"Pass the function itself: `{written.split('(')[0]}`, without brackets.",
                (timer.where,),
            )
    return None


def long_period(sources: Sources) -> Cause | None:
    """A period of many seconds is one that was meant in milliseconds."""
    for timer in calls(sources, "create_timer"):
        value = number(sources, timer.argument(0, "timer_period_sec"))
        if value is not None and value >= _LONG:
            return Cause(
                f"The period of `create_timer` is in seconds: {value:g} means one call every {value:g} s. "
                f"Write `{value / 1000:g}`.",
                (timer.where,),
            )
    return None


def timer_places(sources: Sources) -> tuple[Location, ...]:
    """Where timers are made."""
    return tuple(timer.where for timer in calls(sources, "create_timer"))


def _makes_a_callable(call: ast.Call) -> bool:
    """`functools.partial(...)` and the like are right."""
    name = call.func.attr if isinstance(call.func, ast.Attribute) else getattr(call.func, "id", "")
    return "callback" not in name and not name.startswith("on_")
