"""What every event handler has: a matcher, and what it does with an event."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from launch.event import Event
from launch.launch_description_entity import LaunchDescriptionEntity

Matcher = Callable[[Event], bool]
_Event = Event
_Context = Any  # LaunchContext, which keeps handlers and so imports this module


class BaseEventHandler:
    """`handle_once`: gone after the first event."""

    def __init__(self, *, matcher: Matcher, handle_once: bool = False) -> None:
        self.__matcher = matcher
        self.__handle_once = handle_once

    @property
    def handle_once(self) -> bool:
        return self.__handle_once

    @property
    def handler_description(self) -> str:
        return ""

    @property
    def matcher_description(self) -> str:
        return ""

    def matches(self, event: Event) -> bool:
        return self.__matcher(event)

    def handle(self, event: Event, context: _Context) -> list[LaunchDescriptionEntity] | None:
        """What comes of the event is visited next."""
        if self.__handle_once:
            context.unregister_event_handler(self)
        return None

    def describe(self) -> tuple[str, list[LaunchDescriptionEntity]]:
        name = type(self).__name__
        return (
            f"{name}(matcher='{self.matcher_description}', handler='{self.handler_description}', "
            f"handle_once={self.handle_once})",
            [],
        )
