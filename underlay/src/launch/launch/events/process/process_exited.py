"""A process has ended."""

from __future__ import annotations

from typing import Any

from launch.events.process.running_process_event import RunningProcessEvent


class ProcessExited(RunningProcessEvent):
    """`returncode` is negative for a death by a signal."""

    name = "launch.events.process.ProcessExited"

    def __init__(self, *, returncode: int, **details: Any) -> None:
        super().__init__(**details)
        self.__returncode = returncode

    @property
    def returncode(self) -> int:
        return self.__returncode
