"""An action has done its work."""

from __future__ import annotations

from launch.action import Action
from launch.event import Event


class ExecutionComplete(Event):
    name = "launch.events.ExecutionComplete"

    def __init__(self, *, action: Action) -> None:
        self.__action = action

    @property
    def action(self) -> Action:
        return self.__action
