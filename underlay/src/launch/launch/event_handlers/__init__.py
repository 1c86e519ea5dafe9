"""Handlers of the events that launch files react to."""

from __future__ import annotations

from launch._lazy import lazily

_NAMES = {
    "OnActionEventBase": "on_action_event_base",
    "OnExecutionComplete": "on_execution_complete",
    "OnIncludeLaunchDescription": "on_include_launch_description",
    "OnProcessExit": "on_process_exit",
    "OnProcessIO": "on_process_io",
    "OnProcessStart": "on_process_start",
    "OnShutdown": "on_shutdown",
}
__all__ = list(_NAMES)
__getattr__ = lazily(__name__, _NAMES)
