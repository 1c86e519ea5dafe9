"""What is usually wrong when a timer's callback does not do what it should."""

from __future__ import annotations

import ast
from dataclasses import dataclass

from course.evidence.sources import Sources
from course.feedback import Location
from course.grading.explain.python_code import called_name, calls, functions, number

_LONG = 10.0
# Where each takes its callback, counted from 0.
TAKERS = {"create_timer": 1, "create_subscription": 2, "create_service": 2, "add_done_callback": 0}


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
    takers = ((call, position) for name, position in TAKERS.items() for call in calls(sources, name))
    for taker, position in takers:
        callback = taker.argument(position, "callback")
        if isinstance(callback, ast.Constant) and callback.value is None:
            text = "`None` stands where the callback belongs: name the function to call."
            return Cause(text, (taker.where,))
        if isinstance(callback, ast.Call) and _gives_nothing(sources, callback):
            written = ast.unparse(callback)
            return Cause(
                f"`{written}` calls the function at once and hands over its result, `None`. "
                f"Pass the function itself: `{written.split('(')[0]}`, without brackets.",
                (taker.where,),
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


def _gives_nothing(sources: Sources, call: ast.Call) -> bool:
    """A function of the learner's that returns no value; `functools.partial(...)` and the like are right."""
    name = called_name(call)
    own = functions(sources, name)
    if own:
        return not any(isinstance(n, ast.Return) and n.value for function in own for n in ast.walk(function))
    return "callback" in name or name.startswith("on_")
