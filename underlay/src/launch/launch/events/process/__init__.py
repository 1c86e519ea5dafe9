"""What can happen to a process, and what can be asked of it."""

from __future__ import annotations

from launch._lazy import lazily

_NAMES = {
    "ProcessExited": "process_exited",
    "ProcessIO": "process_io",
    "ProcessStarted": "process_started",
    "ProcessStderr": "process_io",
    "ProcessStdin": "process_io",
    "ProcessStdout": "process_io",
    "ProcessTargetedEvent": "process_targeted_event",
    "RunningProcessEvent": "running_process_event",
    "ShutdownProcess": "shutdown_process",
    "SignalProcess": "signal_process",
}
_MATCHERS = ("matches_executable", "matches_name", "matches_pid")
__all__ = [*_NAMES, *_MATCHERS]
_find = lazily(__name__, _NAMES)


def __getattr__(name: str) -> object:
    if name in _MATCHERS:
        from launch.events import matchers

        return getattr(matchers, name)
    return _find(name)
