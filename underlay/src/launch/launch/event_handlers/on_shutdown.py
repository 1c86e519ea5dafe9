"""When the launch ends."""

from __future__ import annotations

from typing import Any

from launch.action import entities_of
from launch.event import Event
from launch.event_handlers.base import BaseEventHandler
from launch.events.shutdown import Shutdown
from launch.launch_description_entity import LaunchDescriptionEntity


class OnShutdown(BaseEventHandler):
    """`on_shutdown`: actions, or a function of the event and the context that may return some."""

    def __init__(self, *, on_shutdown: Any, **kwargs: Any) -> None:
        super().__init__(matcher=lambda event: isinstance(event, Shutdown), **kwargs)
        self.__on_shutdown = on_shutdown

    def handle(self, event: Event, context: Any) -> list[LaunchDescriptionEntity] | None:
        super().handle(event, context)
        if callable(self.__on_shutdown):
            return entities_of(self.__on_shutdown(event, context))
        return entities_of(self.__on_shutdown)

    @property
    def matcher_description(self) -> str:
        return "event issubclass of launch.events.Shutdown"

    @property
    def handler_description(self) -> str:
        return f"{self.__on_shutdown}" if callable(self.__on_shutdown) else "{actions}"

    def describe(self) -> tuple[str, list[LaunchDescriptionEntity]]:
        text, _ = super().describe()
        return text, [] if callable(self.__on_shutdown) else entities_of(self.__on_shutdown)
