"""End the launch."""

from __future__ import annotations

from typing import Any

from launch.actions.emit_event import EmitEvent
from launch.events.process.process_exited import ProcessExited
from launch.events.shutdown import Shutdown as ShutdownEvent
from launch.launch_context import LaunchContext


class Shutdown(EmitEvent):
    """Processes get SIGINT, and more where that is not enough."""

    def __init__(self, *, reason: str = "reason not given", **kwargs: Any) -> None:
        super().__init__(event=ShutdownEvent(reason=reason), **kwargs)

    def execute(self, context: LaunchContext) -> None:
        from launch.logging import get_logger

        event = context.get_locals_as_dict().get("event")
        if isinstance(event, ProcessExited):
            get_logger("launch").info(
                f"process[{event.process_name}] was required: shutting down launched system"
            )
        super().execute(context)


ShutdownAction = Shutdown
