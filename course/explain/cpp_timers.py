"""Common mistakes in C++ that keep a timer's function from being called as it should be."""

from __future__ import annotations

import re
from collections.abc import Iterator

from course.evidence.sources import Sources
from course.explain.cpp_code import CppCall, cpp_calls, cpp_files, only_code, places_of
from course.explain.engine import Cause
from course.model.feedback import Location

MAKERS = ("create_wall_timer", "create_timer")
SPINS = ("spin", "spin_some", "spin_once", "spin_all", "spin_until_future_complete")
_LONG = 10.0
_UNITS = {"h": 3600.0, "min": 60.0, "s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}
_NAMED = {"hours": "h", "minutes": "min", "seconds": "s", "milliseconds": "ms", "microseconds": "us"}
_WITH_UNIT = re.compile(r"^\s*(?P<value>[\d.']+)(?P<unit>h|min|s|ms|us|ns)\b")
_LONG_FORM = re.compile(rf"\b(?P<unit>{'|'.join(_NAMED)})\s*[({{]\s*(?P<value>[\d.']+)\s*[)}}]")
# What the function is called on: `this->`, `node.`, `rclcpp::`, or nothing.
_CALLED_ON = r"(?:\w+\s*(?:->|\.|::)\s*)*"
# `auto timer =` and `rclcpp::TimerBase::SharedPtr timer{`, but not `timer_ =` or a static one.
_DECLARED = re.compile(rf"(?!return\b|static\b)(?:[\w:]+(?:<[^;<>]*>)?[\s&*]+)+\w+\s*[={{(]\s*{_CALLED_ON}")
_NOT_KEPT = re.compile(_CALLED_ON)
_LONGEST = 200
# One divided by a larger whole number.
_DIVISION = r"(?<![\w.])1\s*/\s*(?:[2-9]|[1-9]\d+)(?![\w.])"


def cpp_timer_cause(sources: Sources) -> Cause | None:
    """Why a timer's function is not called, such as: no timer, one that nothing keeps, or a long period."""
    timers = timers_of(sources)
    rates = places_of(sources, r"\bRate\b|\bWallRate\b|\bsleep_for\b")
    if not timers and rates:
        return _slow_rate(sources)
    if not timers:
        return Cause(
            "The code does not create a timer. Write `timer_ = create_wall_timer(500ms, ...)` in the node's "
            "constructor.",
            places_of(sources, r":\s*(?:rclcpp::)?Node\s*\(")[:1],
        )
    return _lost(timers) or _long_period(timers) or _another_node(sources) or _spun_too_early(sources)


def timers_of(sources: Sources) -> tuple[CppCall, ...]:
    return tuple(call for name in MAKERS for call in cpp_calls(sources, name))


def _lost(timers: tuple[CppCall, ...]) -> Cause | None:
    """A timer exists only while something owns it; a local variable owns it until its function returns."""
    for timer in timers:
        if any(re.search(rf"\b{name}\s*\(", timer.around) for name in SPINS):
            continue  # it lives while the node spins
        if len(timer.before) > _LONGEST:
            continue
        if _DECLARED.fullmatch(timer.before):
            text = "The timer is in a local variable, which ends with the function. Use a class member:"
            return Cause(f"{text} `timer_ = ...`, without a type before it.", (timer.where,))
        if _NOT_KEPT.fullmatch(timer.before):
            text = "Nothing stores the timer, so it is deleted immediately. Use a member of the class:"
            return Cause(f"{text} `timer_ = create_wall_timer(...)`.", (timer.where,))
    return None


def _long_period(timers: tuple[CppCall, ...]) -> Cause | None:
    for value, written, where in _periods(timers):
        if value >= _LONG:
            text = f"The timer waits {value:g} s before each call: `{written}`."
            return Cause(f"{text} Half a second is `500ms`.", (where,))
    return None


def _periods(timers: tuple[CppCall, ...]) -> Iterator[tuple[float, str, Location]]:
    """Periods written with a unit: the seconds, the text as written, and the place."""
    for timer in timers:
        written = _WITH_UNIT.match(timer.arguments) or _LONG_FORM.search(timer.arguments)
        value = _number(written["value"]) if written else None
        if written and value is not None:
            unit = _NAMED.get(written["unit"], written["unit"])
            yield value * _UNITS[unit], written[0].strip(), timer.where


def cpp_periods(sources: Sources) -> list[tuple[float, Location]]:
    """The periods (s) of timers that are written with a unit."""
    return [(value, where) for value, _, where in _periods(timers_of(sources))]


def integer_division(sources: Sources) -> Cause | None:
    """`1/2`, which is 0 in C++."""
    for found in places_of(sources, _DIVISION):
        return Cause(
            "Dividing two whole numbers in C++ drops the fraction: `1/2` is 0. Write `1.0/2`, or `0.5`.",
            (found,),
        )
    return None


def rate_unused(sources: Sources) -> Cause | None:
    """`rclcpp::Rate rate(2)`, of which no code calls `sleep`."""
    for code in map(only_code, cpp_files(sources).values()):
        sleeping = set(re.findall(r"\b(\w+)\s*\.\s*sleep\b", code))
        for made in re.finditer(r"\b(?:Wall)?Rate\s+(\w+)\s*[({]", code):
            if made[1] not in sleeping:
                text = f"Nothing waits: the loop must call `{made[1]}.sleep();` each time."
                return Cause(text, places_of(sources, r"\bwhile\s*\(")[:1])
    return None


def _slow_rate(sources: Sources) -> Cause | None:
    """`rclcpp::Rate rate(0.5)`, which means once every two seconds."""
    where = places_of(sources, r"Rate\s*\w*\s*[({]\s*0?\.\d+\s*[)}]")
    text = "A rate is the number of calls per second, not the time between them: twice per second is 2.0."
    return Cause(text, where[:1]) if where else None


def _another_node(sources: Sources) -> Cause | None:
    """A plain node is created and spun, but the class with the timer is not used."""
    derives = any(
        re.search(r"public\s+rclcpp::Node\b", only_code(text)) for text in cpp_files(sources).values()
    )
    plain = places_of(sources, r"make_shared\s*<\s*rclcpp::Node\s*>")
    if not derives or not plain:
        return None
    return Cause(
        "The program creates a plain `rclcpp::Node`, which has no timer. Create a node of your own class: "
        "`std::make_shared<...>()` with the class's name.",
        plain,
    )


def _spun_too_early(sources: Sources) -> Cause | None:
    """`spin` comes before the timer in the same block, and returns only when the program ends."""
    for timer in timers_of(sources):
        spun = [found.start() for found in re.finditer(r"\bspin\s*\(", timer.around)]
        made = [found.start() for name in MAKERS for found in re.finditer(rf"\b{name}\b", timer.around)]
        if spun and made and spun[0] < made[0]:
            text = "`rclcpp::spin` only returns when the program ends. Create the timer before it."
            return Cause(text, (timer.where,))
    return None


def _number(text: str) -> float | None:
    try:
        return float(text.replace("'", ""))
    except ValueError:
        return None
