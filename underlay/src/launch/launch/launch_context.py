"""What the entities of one launch share: configurations, the environment, local values, events."""

from __future__ import annotations

import asyncio
import os
from collections import deque
from collections.abc import Callable, Iterable, Mapping, MutableMapping
from typing import Any

from launch.child.guard import Guard
from launch.event import Event
from launch.event_handlers.base import BaseEventHandler
from launch.substitution import Substitution
from launch.utilities.scoped_environment import EnvironmentStack


class Locals:
    """The local values as attributes: `context.locals.event`."""

    def __init__(self, values: Mapping[str, Any]) -> None:
        self.__dict__.update(values)

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(f"context.locals does not contain attribute '{name}'")


class LaunchContext:
    """One per launch service; handed to every entity that is visited."""

    def __init__(self, *, argv: Iterable[str] | None = None, noninteractive: bool = False) -> None:
        self.__argv = list(argv or ())
        self.__noninteractive = noninteractive
        self.__globals: dict[str, Any] = {}
        self.__locals_stack: list[dict[str, Any]] = [{}]
        self.__configurations_stack: list[dict[str, str]] = []
        self.__environment = EnvironmentStack()
        self.launch_configurations: dict[str, Any] = {}
        self.__loop: asyncio.AbstractEventLoop | None = None
        self.__is_shutdown = False
        self._starting = asyncio.Lock()
        self._guard = Guard()
        self._events: deque[Event] = deque()
        self._event_handlers: deque[BaseEventHandler] = deque()
        self._wake: Callable[[], None] = lambda: None

    @property
    def argv(self) -> list[str]:
        return self.__argv

    @property
    def noninteractive(self) -> bool:
        return self.__noninteractive

    # -- running ---------------------------------------------------------------------------------------

    @property
    def asyncio_loop(self) -> asyncio.AbstractEventLoop | None:
        return self.__loop

    def _set_asyncio_loop(self, loop: asyncio.AbstractEventLoop | None) -> None:
        self.__loop = loop

    @property
    def is_shutdown(self) -> bool:
        return self.__is_shutdown

    def _set_is_shutdown(self, state: bool) -> None:
        self.__is_shutdown = state

    # -- values ----------------------------------------------------------------------------------------

    @property
    def locals(self) -> Locals:
        return Locals(self.get_locals_as_dict())

    def get_locals_as_dict(self) -> dict[str, Any]:
        merged = dict(self.__globals)
        for level in self.__locals_stack:
            merged.update(level)
        return merged

    def extend_globals(self, values: Mapping[str, Any]) -> None:
        self.__globals.update(values)

    def extend_locals(self, values: Mapping[str, Any]) -> None:
        self.__locals_stack[-1].update(values)

    def _push_locals(self) -> None:
        self.__locals_stack.append({})

    def _pop_locals(self) -> None:
        if len(self.__locals_stack) == 1:
            raise RuntimeError("locals stack unexpectedly empty")
        self.__locals_stack.pop()

    def _push_launch_configurations(self) -> None:
        self.__configurations_stack.append(dict(self.launch_configurations))

    def _pop_launch_configurations(self) -> None:
        if not self.__configurations_stack:
            raise RuntimeError("launch configurations stack unexpectedly empty")
        self.launch_configurations = self.__configurations_stack.pop()

    @property
    def environment(self) -> MutableMapping[str, str]:
        return os.environ

    def _push_environment(self) -> None:
        self.__environment.push()

    def _pop_environment(self) -> None:
        self.__environment.pop()

    def _reset_environment(self) -> None:
        self.__environment.reset()

    def _replace_environment(self, environment: Mapping[str, str]) -> None:
        self.__environment.replace(environment)

    def perform_substitution(self, substitution: Substitution) -> str:
        return substitution.perform(self)

    # -- events ----------------------------------------------------------------------------------------

    def register_event_handler(self, event_handler: BaseEventHandler, append: bool = False) -> None:
        """The newest handler is asked first, unless it is appended."""
        if append:
            self._event_handlers.append(event_handler)
        else:
            self._event_handlers.appendleft(event_handler)

    def unregister_event_handler(self, event_handler: BaseEventHandler) -> None:
        if event_handler not in self._event_handlers:
            raise ValueError("The given event handler is not registered.")
        self._event_handlers.remove(event_handler)

    def would_handle_event(self, event: Event) -> bool:
        return any(handler.matches(event) for handler in self._event_handlers)

    def emit_event_sync(self, event: Event) -> None:
        """From the launch's own thread; handled after what is being visited now."""
        self._events.append(event)
        self._wake()

    async def emit_event(self, event: Event) -> None:
        self.emit_event_sync(event)
