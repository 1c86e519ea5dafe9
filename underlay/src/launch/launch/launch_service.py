"""Runs a launch: visits what the descriptions say, handles events, goes on until nothing is left."""

from __future__ import annotations

import asyncio
import logging
import traceback
from collections.abc import Iterable

from launch.event import Event
from launch.event_handlers.base import BaseEventHandler
from launch.event_handlers.on_include_launch_description import OnIncludeLaunchDescription
from launch.event_handlers.on_shutdown import OnShutdown
from launch.events.include_launch_description import IncludeLaunchDescription
from launch.events.shutdown import Shutdown
from launch.launch_context import LaunchContext
from launch.launch_description import LaunchDescription
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.logging import get_logger, launch_config, log_launch_config
from launch.logging.screen import ScreenHandler
from launch.termination import Interruptions
from launch.utilities.visit import Visited, visit_all


class LaunchService:
    """`run` returns 0, or 1 after an exception in what was launched."""

    def __init__(
        self, *, argv: Iterable[str] | None = None, noninteractive: bool = False, debug: bool = False
    ) -> None:
        if debug:
            launch_config.level = logging.DEBUG
        self.__debug = debug
        self.__logger = get_logger("launch")
        log_launch_config(logger=self.__logger)
        self.__context = LaunchContext(argv=argv, noninteractive=noninteractive)
        self.__context.register_event_handler(OnIncludeLaunchDescription())
        self.__context.register_event_handler(OnShutdown(on_shutdown=self._on_shutdown))
        self.__futures: dict[asyncio.Future[None], LaunchDescriptionEntity] = {}
        self.__wake: asyncio.Event | None = None
        self.__task: asyncio.Task[int] | None = None
        self.__shutting_down = False
        self.__return_code = 0
        self.__interruptions = Interruptions(self)

    @property
    def context(self) -> LaunchContext:
        return self.__context

    @property
    def event_loop(self) -> asyncio.AbstractEventLoop | None:
        return self.__context.asyncio_loop

    @property
    def task(self) -> asyncio.Task[int] | None:
        return self.__task

    @property
    def ended_by_signal(self) -> int | None:
        """The signal, other than Ctrl+C, that told the launch to end."""
        return self.__interruptions.ended_by

    # -- what others ask for ---------------------------------------------------------------------------

    def include_launch_description(self, launch_description: LaunchDescription) -> None:
        self.emit_event(IncludeLaunchDescription(launch_description))

    def emit_event(self, event: Event) -> None:
        """Can be called from any thread."""
        loop = self.event_loop
        if loop is None or not loop.is_running():
            self.__context.emit_event_sync(event)
        else:
            loop.call_soon_threadsafe(self.__context.emit_event_sync, event)

    def shutdown(self, force_sync: bool = False) -> None:
        """End the launch from outside; from any thread."""
        if self.event_loop is not None:
            self.end("LaunchService.shutdown() called")

    def end(self, reason: str, *, due_to_sigint: bool = False) -> None:
        """Tell everyone, once, that the launch ends."""
        if not self.__shutting_down:
            self.__shutting_down = True
            self.emit_event(Shutdown(reason=reason, due_to_sigint=due_to_sigint))

    # -- running ---------------------------------------------------------------------------------------

    def run(self, *, shutdown_when_idle: bool = True) -> int:
        """Run in an event loop of its own; Ctrl+C and SIGTERM are taken care of."""
        loop = asyncio.new_event_loop()
        loop.set_debug(self.__debug)
        try:
            return loop.run_until_complete(self.run_async(shutdown_when_idle=shutdown_when_idle))
        finally:
            loop.run_until_complete(loop.shutdown_asyncgens())
            loop.close()

    async def run_async(self, *, shutdown_when_idle: bool = True) -> int:
        self._begin()
        ScreenHandler.on_closed.append(self._on_screen_closed)
        try:
            with self.__interruptions.handled():
                await self._run_until_done(shutdown_when_idle)
        finally:
            ScreenHandler.on_closed.remove(self._on_screen_closed)
            self._finish()
        return self.__return_code

    def _begin(self) -> None:
        if self.event_loop is not None:
            raise RuntimeError("LaunchService cannot be run multiple times concurrently.")
        self.__wake = asyncio.Event()
        self.__task = asyncio.current_task()
        self.__shutting_down = False
        self.__return_code = 0
        self.__context._set_is_shutdown(False)
        self.__context._set_asyncio_loop(asyncio.get_running_loop())
        self.__context._wake = self.__wake.set

    def _finish(self) -> None:
        self.__context._wake = lambda: None
        self.__context._guard.close()
        self.__context._set_asyncio_loop(None)
        self.__context._set_is_shutdown(True)
        self.__futures.clear()

    async def _run_until_done(self, shutdown_when_idle: bool) -> None:
        assert self.__wake is not None
        while True:
            self._handle_waiting_events()
            self._drop_done_futures()
            if self.__context._events:
                continue
            if not self.__futures and self.__shutting_down:
                return
            if not self.__futures and shutdown_when_idle:
                self.end("idle")
                continue
            await self.__wake.wait()
            self.__wake.clear()

    def _handle_waiting_events(self) -> None:
        while self.__context._events:
            event = self.__context._events.popleft()
            self.__logger.debug("processing event: '%s'", event)
            for handler in tuple(self.__context._event_handlers):
                if handler.matches(event):
                    self._handle(handler, event)

    def _handle(self, handler: BaseEventHandler, event: Event) -> None:
        """One exception ends the launch, but keeps no other handler from its work."""
        self.__context._push_locals()
        try:
            self.__context.extend_locals({"event": event})
            for entity in handler.handle(event, self.__context) or ():
                self._visit(entity)
        except Exception as error:  # noqa: BLE001  whatever a launch file does wrong
            self._fail(error)
        finally:
            self.__context._pop_locals()

    def _visit(self, entity: LaunchDescriptionEntity) -> None:
        begun: Visited = []
        try:
            visit_all(entity, self.__context, begun)
        finally:
            for visited, future in begun:
                self.__futures[future] = visited
                future.add_done_callback(lambda _: self.__context._wake())

    def _drop_done_futures(self) -> None:
        for future in [future for future in self.__futures if future.done()]:
            del self.__futures[future]
            if not future.cancelled() and (error := future.exception()) is not None:
                self._fail(error)

    def _fail(self, error: BaseException) -> None:
        told = f"Caught exception in launch (see debug for traceback): {error}"
        self.__logger.debug("".join(traceback.format_exception(error)).rstrip())
        self.__logger.error(told)
        self.__return_code = 1
        self.end(told)

    # -- ending ----------------------------------------------------------------------------------------

    def _on_shutdown(self, event: Event, context: LaunchContext) -> None:
        self.__shutting_down = True
        context._set_is_shutdown(True)

    def _on_screen_closed(self) -> None:
        self.end("nobody reads the output any more")
