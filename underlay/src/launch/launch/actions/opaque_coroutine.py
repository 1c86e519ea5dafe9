"""Run a coroutine while the launch runs."""

from __future__ import annotations

import asyncio
import inspect
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from launch.action import Action
from launch.event_handlers.on_shutdown import OnShutdown
from launch.launch_context import LaunchContext


class OpaqueCoroutine(Action):
    """It gets the context, unless `ignore_context`, and is cancelled when the launch ends."""

    def __init__(
        self,
        *,
        coroutine: Callable[..., Any],
        args: Iterable[Any] | None = None,
        kwargs: Mapping[str, Any] | None = None,
        ignore_context: bool = False,
        **more: Any,
    ) -> None:
        super().__init__(**more)
        if not inspect.iscoroutinefunction(coroutine):
            raise TypeError(f"OpaqueCoroutine expected a coroutine function, got '{type(coroutine)}'")
        self.__coroutine = coroutine
        self.__args = list(args or ())
        self.__kwargs = dict(kwargs or {})
        self.__ignore_context = ignore_context
        self.__future: asyncio.Task[Any] | None = None

    def execute(self, context: LaunchContext) -> None:
        assert context.asyncio_loop is not None
        args = self.__args if self.__ignore_context else [context, *self.__args]
        task = context.asyncio_loop.create_task(self.__coroutine(*args, **self.__kwargs))
        context.register_event_handler(OnShutdown(on_shutdown=lambda *_: self._cancel()))
        self.__future = task

    def _cancel(self) -> None:
        if self.__future is not None:
            self.__future.cancel()

    def get_asyncio_future(self) -> asyncio.Future[Any] | None:
        return self.__future
