"""What is usually wrong in C++ when a timer's function is not called as it should be."""

from __future__ import annotations

import re

from course.evidence.sources import Sources
from course.grading.explain.cpp_code import CppCall, cpp_calls, cpp_files, only_code, places_of
from course.grading.explain.timers import Cause

MAKERS = ("create_wall_timer", "create_timer")
SPINS = ("spin", "spin_some", "spin_once", "spin_all", "spin_until_future_complete")
_LONG = 10.0
_UNITS = {"h": 3600.0, "min": 60.0, "s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}
_NAMED = {"hours": "h", "minutes": "min", "seconds": "s", "milliseconds": "ms", "microseconds": "us"}
_WITH_UNIT = re.compile(r"^\s*(?P<value>[\d.']+)(?P<unit>h|min|s|ms|us|ns)\b")
_LONG_FORM = re.compile(rf"\b(?P<unit>{'|'.join(_NAMED)})\s*[({{]\s*(?P<value>[\d.']+)\s*[)}}]")
# What it is called on: `this->`, `node.`, `rclcpp::`, or nothing.
_CALLED_ON = r"(?:\w+\s*(?:->|\.|::)\s*)*"
# `auto timer =` and `rclcpp::TimerBase::SharedPtr timer{`, but not `timer_ =`, nor one that stays.
_DECLARED = re.compile(rf"(?!return\b|static\b)(?:[\w:]+(?:<[^;<>]*>)?[\s&*]+)+\w+\s*[={{(]\s*{_CALLED_ON}")
_NOT_KEPT = re.compile(_CALLED_ON)
_LONGEST = 200


def cpp_timer_cause(sources: Sources) -> Cause | None:
    """Why no call comes: no timer, one that nobody keeps, or seconds for milliseconds."""
    timers = timers_of(sources)
    if not timers:
        return Cause("No timer is made anywhere: `timer_ = create_wall_timer(500ms, ...)` where the node is.")
    return _lost(timers) or _long_period(timers) or _another_node(sources) or _spun_too_early(sources)


def timers_of(sources: Sources) -> tuple[CppCall, ...]:
    return tuple(call for name in MAKERS for call in cpp_calls(sources, name))


def _lost(timers: tuple[CppCall, ...]) -> Cause | None:
    """A timer lives as long as somebody holds it: a local variable does so until its function returns."""
    for timer in timers:
        if any(re.search(rf"\b{name}\s*\(", timer.around) for name in SPINS):
            continue  # it is held while the node spins
        if len(timer.before) > _LONGEST:
            continue
        if _DECLARED.fullmatch(timer.before):
            text = "The timer is kept in a local variable, and ends with it. A member of the class keeps it:"
            return Cause(f"{text} `timer_ = ...`, with no type in front.", (timer.where,))
        if _NOT_KEPT.fullmatch(timer.before):
            text = "Nobody keeps the timer, so it ends at once. Let a member of the class keep it:"
            return Cause(f"{text} `timer_ = create_wall_timer(...)`.", (timer.where,))
    return None


def _long_period(timers: tuple[CppCall, ...]) -> Cause | None:
    for timer in timers:
        written = _WITH_UNIT.match(timer.arguments) or _LONG_FORM.search(timer.arguments)
        if not written:
            continue
        unit = _NAMED.get(written["unit"], written["unit"])
        value = _number(written["value"])
        if value is not None and value * _UNITS[unit] >= _LONG:
            text = f"The timer waits {value * _UNITS[unit]:g} s for each call: `{written[0].strip()}`."
            return Cause(f"{text} Half a second is `500ms`.", (timer.where,))
    return None


def _another_node(sources: Sources) -> Cause | None:
    """A plain node is made and spun, and the class that has the timer is not used."""
    derives = any(
        re.search(r"public\s+rclcpp::Node\b", only_code(text)) for text in cpp_files(sources).values()
    )
    plain = places_of(sources, r"make_shared\s*<\s*rclcpp::Node\s*>")
    if not derives or not plain:
        return None
    return Cause(
        "A plain `rclcpp::Node` is made, which has no timer. Make one of your own class: "
        "`std::make_shared<...>()` with its name.",
        plain,
    )


def _spun_too_early(sources: Sources) -> Cause | None:
    """`spin` in the same block before the timer is made: it comes back only at the end."""
    for timer in timers_of(sources):
        spun = [found.start() for found in re.finditer(r"\bspin\s*\(", timer.around)]
        made = [found.start() for name in MAKERS for found in re.finditer(rf"\b{name}\b", timer.around)]
        if spun and made and spun[0] < made[0]:
            text = "`rclcpp::spin` comes back only at the end. Make the timer before it."
            return Cause(text, (timer.where,))
    return None


def _number(text: str) -> float | None:
    try:
        return float(text.replace("'", ""))
    except ValueError:
        return None
