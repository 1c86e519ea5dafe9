"""What is done when something happened."""

from __future__ import annotations

from launch.action import entities_of
from launch.event_handlers.base import BaseEventHandler, Matcher, _Context, _Event
from launch.launch_description_entity import LaunchDescriptionEntity

__all__ = ["BaseEventHandler", "EventHandler"]


class EventHandler(BaseEventHandler):
    """Brings entities into play when an event matches."""

    def __init__(self, *, matcher: Matcher, entities: object = None, handle_once: bool = False) -> None:
        super().__init__(matcher=matcher, handle_once=handle_once)
        self.__entities = entities

    @property
    def entities(self) -> object:
        return self.__entities

    def handle(self, event: _Event, context: _Context) -> list[LaunchDescriptionEntity] | None:
        super().handle(event, context)
        return entities_of(self.__entities)
