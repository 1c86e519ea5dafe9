"""Handlers of events about an action: a given one, some of them, or any."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from launch.action import Action, entities_of
from launch.event import Event
from launch.event_handlers.base import BaseEventHandler
from launch.launch_description_entity import LaunchDescriptionEntity

_MATCHERS = "event == {} and event.action == {}"


class OnActionEventBase(BaseEventHandler):
    """`action_matcher` is an action, a question asked of one, or None for any."""

    def __init__(
        self,
        *,
        action_matcher: Action | Callable[[Action], bool] | None,
        on_event: Any,
        target_event_cls: type[Event],
        target_action_cls: type[Action],
        **kwargs: Any,
    ) -> None:
        if not (action_matcher is None or callable(action_matcher)):
            _require_action(action_matcher, target_action_cls)
        self.__action = action_matcher
        self.__event_class = target_event_cls
        self.__action_class = target_action_cls
        self.__on_event = on_event if callable(on_event) else entities_of(on_event)
        super().__init__(matcher=self._matches, **kwargs)

    def _matches(self, event: Event) -> bool:
        if not isinstance(event, self.__event_class):
            return False
        action = event.action  # type: ignore[attr-defined]
        if not isinstance(action, self.__action_class):
            return False
        if self.__action is None or self.__action is action:
            return True
        return callable(self.__action) and bool(self.__action(action))

    def handle(self, event: Event, context: Any) -> list[LaunchDescriptionEntity] | None:
        super().handle(event, context)
        if callable(self.__on_event):
            return entities_of(self.__on_event(event, context))
        return list(self.__on_event)

    def describe(self) -> tuple[str, list[LaunchDescriptionEntity]]:
        text, _ = super().describe()
        return text, [] if callable(self.__on_event) else list(self.__on_event)

    @property
    def handler_description(self) -> str:
        return f"{self.__on_event}" if callable(self.__on_event) else "{actions}"

    @property
    def matcher_description(self) -> str:
        action = "any" if self.__action is None else type(self.__action).__name__
        return _MATCHERS.format(self.__event_class.__name__, action)


def _require_action(action: object, kind: type[Action]) -> None:
    if not isinstance(action, kind):
        raise ValueError(f"expected an '{kind.__name__}' action or a function, got {action!r}")
