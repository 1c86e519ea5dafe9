"""Which process, or which action, an event is about."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from launch.action import Action

_Matcher = Callable[[Any], bool]


def matches_action(target_action: Action) -> _Matcher:
    return lambda action: action is target_action


def matches_pid(pid: int) -> _Matcher:
    return lambda action: (action.process_details or {}).get("pid") == pid


def matches_name(name: str) -> _Matcher:
    return lambda action: (action.process_details or {}).get("name") == name


def matches_executable(executable: str) -> _Matcher:
    """By the program, given as a path or as its last part."""

    def matches(action: Any) -> bool:
        program = str(((action.process_details or {}).get("cmd") or [""])[0])
        return executable in (program, program.rpartition("/")[2])

    return matches
