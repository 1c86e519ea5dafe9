"""When a launch description is taken in."""

from __future__ import annotations

from typing import Any

from launch.event import Event
from launch.event_handlers.base import BaseEventHandler
from launch.events.include_launch_description import IncludeLaunchDescription
from launch.launch_description_entity import LaunchDescriptionEntity


class OnIncludeLaunchDescription(BaseEventHandler):
    def __init__(self, **kwargs: Any) -> None:
        super().__init__(matcher=lambda event: isinstance(event, IncludeLaunchDescription), **kwargs)

    def handle(self, event: Event, context: Any) -> list[LaunchDescriptionEntity] | None:
        super().handle(event, context)
        return [event.launch_description] if isinstance(event, IncludeLaunchDescription) else None
