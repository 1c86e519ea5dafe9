"""The time of a timer is over."""

from __future__ import annotations

from launch.action import Action
from launch.event import Event


class TimerEvent(Event):
    name = "launch.events.TimerEvent"

    def __init__(self, *, timer_action: Action) -> None:
        self.__timer_action = timer_action

    @property
    def timer_action(self) -> Action:
        return self.__timer_action
