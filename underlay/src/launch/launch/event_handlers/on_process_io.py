"""When a process writes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from launch.action import entities_of
from launch.actions.execute_local import ExecuteLocal
from launch.event_handlers.on_action_event_base import OnActionEventBase
from launch.events.process.process_io import ProcessIO
from launch.launch_description_entity import LaunchDescriptionEntity

_Callback = Callable[[ProcessIO], Any]


class OnProcessIO(OnActionEventBase):
    """Each callback gets the event (its `text` is bytes) and may return actions."""

    def __init__(
        self,
        *,
        target_action: Any = None,
        on_stdin: _Callback | None = None,
        on_stdout: _Callback | None = None,
        on_stderr: _Callback | None = None,
        **kwargs: Any,
    ) -> None:
        self.__callbacks = (on_stdin, on_stdout, on_stderr)
        super().__init__(
            action_matcher=target_action,
            on_event=self._on_io,
            target_event_cls=ProcessIO,
            target_action_cls=ExecuteLocal,
            **kwargs,
        )

    def _on_io(self, event: ProcessIO, context: Any) -> list[LaunchDescriptionEntity]:
        callback = self.__callbacks[event.fd]
        return [] if callback is None else entities_of(callback(event))
