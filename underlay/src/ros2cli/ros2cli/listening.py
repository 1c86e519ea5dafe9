"""Takes messages as they come, without rclpy's executor: that one costs more than a small message takes."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

from ros2cli.rcl import extension

_SLICE = 0.05


class Stop(Exception):
    """Raised by a callback that has enough."""


def listen(
    node: Any,
    subscription: Any,
    on_message: Callable[[Any, Any], None],
    *,
    every: tuple[float, Callable[[], None]] | None = None,
    timeout: float | None = None,
) -> int:
    """Give each message and its times to `on_message`, until that or a signal ends it, or `timeout` is over.

    `every` is a period in seconds and what to call at each of its ends. The exit code: 0, 15 after SIGTERM.
    """
    clock = _Clock(every, timeout)
    try:
        while node.context.ok() and not clock.is_over():
            if _wait(node, subscription, clock.slice()):
                _take_all(subscription, on_message)
            clock.tick()
    except Stop:
        return 0
    return 0 if node.context.ok() else 15


class _Clock:
    """When to call the next time, and when to end."""

    def __init__(self, every: tuple[float, Callable[[], None]] | None, timeout: float | None) -> None:
        now = time.monotonic()
        self._period, self._call = every or (float("inf"), lambda: None)
        self._next = now + self._period
        self._end = float("inf") if timeout is None else now + timeout

    def is_over(self) -> bool:
        return time.monotonic() >= self._end

    def slice(self) -> float:
        return max(0.0, min(_SLICE, self._next - time.monotonic(), self._end - time.monotonic()))

    def tick(self) -> None:
        if time.monotonic() >= self._next:
            self._next = max(self._next + self._period, time.monotonic())
            self._call()


def _wait(node: Any, subscription: Any, seconds: float) -> bool:
    with node.context.handle, subscription.handle:
        events = subscription.event_handlers
        wait_set = extension().WaitSet(1, 0, 0, 0, 0, len(events), node.context.handle)
        wait_set.add_subscription(subscription.handle)
        for event in events:
            event.add_to_wait_set(wait_set)
        wait_set.wait(int(seconds * 1e9))
        for event in events:
            _tell(event, wait_set)
        return bool(wait_set.is_ready("subscription", 0))


def _tell(event: Any, wait_set: Any) -> None:
    """Call the event's callback when it has happened."""
    if event.is_ready(wait_set):
        data = event.take_data()
        if data is not None:
            event.callback(data)


def _take_all(subscription: Any, on_message: Callable[[Any, Any], None]) -> None:
    while taken := subscription.handle.take_message(subscription.msg_type, subscription.raw):
        on_message(*taken)
