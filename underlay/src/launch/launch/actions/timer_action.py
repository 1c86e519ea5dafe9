"""Do something after some time."""

from __future__ import annotations

import asyncio
from collections.abc import Iterable
from typing import Any

from launch.action import Action, texts
from launch.event_handlers.base import BaseEventHandler
from launch.event_handlers.on_shutdown import OnShutdown
from launch.events.timer_event import TimerEvent
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.substitution import Substitution
from launch.utilities import perform_substitutions


class TimerAction(Action):
    """`period` in seconds. Ends with the launch, unless `cancel_on_shutdown` says no."""

    def __init__(
        self,
        *,
        period: object,
        actions: Iterable[LaunchDescriptionEntity],
        cancel_on_shutdown: object = True,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__period = texts(str(period) if isinstance(period, int | float) else period)
        self.__actions = list(actions)
        shown = str(cancel_on_shutdown) if isinstance(cancel_on_shutdown, bool) else cancel_on_shutdown
        self.__cancel_on_shutdown = texts(shown)
        self.__timer: asyncio.TimerHandle | None = None
        self.__completed_future: asyncio.Future[None] | None = None
        self.__canceled = False

    @property
    def period(self) -> list[Substitution]:
        return self.__period

    @property
    def actions(self) -> list[LaunchDescriptionEntity]:
        return self.__actions

    def describe(self) -> str:
        return f"TimerAction(period={self.__period}, actions=<actions>)"

    def describe_conditional_sub_entities(self) -> list[tuple[str, list[LaunchDescriptionEntity]]]:
        return [("after the period", self.__actions)]

    def get_asyncio_future(self) -> asyncio.Future[None] | None:
        return self.__completed_future

    def cancel(self) -> None:
        """What was to be done will not be."""
        self.__canceled = True
        if self.__timer is not None:
            self.__timer.cancel()
        self._complete()

    def execute(self, context: LaunchContext) -> None:
        assert context.asyncio_loop is not None
        if self.__canceled or context.is_shutdown:
            return
        period = float(perform_substitutions(context, self.__period))
        self.__completed_future = context.asyncio_loop.create_future()
        context.register_event_handler(_WhenOver(self))
        if self._cancels_on_shutdown(context):
            context.register_event_handler(OnShutdown(on_shutdown=lambda *_: self.cancel()))
        self.__timer = context.asyncio_loop.call_later(period, self._over, context)

    def handle(self, context: LaunchContext) -> list[LaunchDescriptionEntity]:
        """What is due now."""
        return self.__actions

    def _cancels_on_shutdown(self, context: LaunchContext) -> bool:
        from launch.conditions import evaluate_condition_expression

        return evaluate_condition_expression(context, self.__cancel_on_shutdown)

    def _over(self, context: LaunchContext) -> None:
        context.emit_event_sync(TimerEvent(timer_action=self))
        self._complete()

    def _complete(self) -> None:
        if self.__completed_future is not None and not self.__completed_future.done():
            self.__completed_future.set_result(None)


class _WhenOver(BaseEventHandler):
    def __init__(self, timer: TimerAction) -> None:
        super().__init__(
            matcher=lambda event: isinstance(event, TimerEvent) and event.timer_action is timer,
            handle_once=True,
        )
        self._timer = timer

    def handle(self, event: Any, context: Any) -> list[LaunchDescriptionEntity]:
        super().handle(event, context)
        return self._timer.handle(context)
