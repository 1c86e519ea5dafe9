"""What can happen in a launch."""

from __future__ import annotations

from launch._lazy import lazily

_NAMES = {
    "ExecutionComplete": "execution_complete",
    "IncludeLaunchDescription": "include_launch_description",
    "Shutdown": "shutdown",
    "TimerEvent": "timer_event",
    "matches_action": "matchers",
    "matches_executable": "matchers",
    "matches_name": "matchers",
    "matches_pid": "matchers",
    "matchers": "matchers",
    "process": "process",
}
__all__ = list(_NAMES)
__getattr__ = lazily(__name__, _NAMES)
