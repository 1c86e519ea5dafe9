"""Start a process, show what it writes, end it with the launch."""

from __future__ import annotations

import asyncio
import signal
from collections.abc import Mapping
from logging import Logger
from typing import Any

from launch.action import Action, entities_of, texts
from launch.child.child import Child
from launch.child.escalation import Escalation
from launch.child.output import Output
from launch.conditions.evaluate_condition_expression_impl import evaluate_condition_expression
from launch.descriptions.executable import Executable
from launch.event import Event
from launch.event_handler import EventHandler
from launch.event_handlers.base import BaseEventHandler
from launch.event_handlers.on_shutdown import OnShutdown
from launch.events.matchers import matches_action
from launch.events.process.process_exited import ProcessExited
from launch.events.process.process_io import ProcessStderr, ProcessStdin, ProcessStdout
from launch.events.process.process_started import ProcessStarted
from launch.events.process.process_targeted_event import ProcessTargetedEvent
from launch.events.process.shutdown_process import ShutdownProcess
from launch.events.process.signal_process import SignalProcess
from launch.events.shutdown import Shutdown
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.logging import get_logger, get_output_loggers
from launch.substitution import Substitution
from launch.substitutions.launch_configuration import LaunchConfiguration
from launch.utilities import perform_substitutions


class ExecuteLocal(Action):
    """One process after the other, if it is to respawn; `process_description` says of what."""

    def __init__(
        self,
        *,
        process_description: Executable,
        shell: bool = False,
        sigterm_timeout: object | None = None,
        sigkill_timeout: object | None = None,
        emulate_tty: object = False,
        output: Any = "log",
        output_format: str = "[{this.process_description.final_name}] {line}",
        cached_output: bool = False,
        log_cmd: bool = False,
        on_exit: Any = None,
        respawn: object = False,
        respawn_delay: object | None = None,
        respawn_max_retries: int = -1,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__process_description = process_description
        self.__shell = shell
        self.__sigterm_timeout = _timeout("sigterm_timeout", sigterm_timeout)
        self.__sigkill_timeout = _timeout("sigkill_timeout", sigkill_timeout)
        self.__emulate_tty = emulate_tty
        self.__output = output if isinstance(output, Mapping) else texts(output)
        self.__output_format = output_format
        self.__cached_output = cached_output
        self.__log_cmd = log_cmd
        self.__on_exit = on_exit
        self.__respawn = respawn
        self.__respawn_delay = texts("0" if respawn_delay is None else _number(respawn_delay))
        self.__respawn_max_retries = respawn_max_retries
        self.__handlers: list[BaseEventHandler] = []
        self.__child: Child | None = None
        self.__executed = False
        self.__return_code: int | None = None
        self.__completed_future: asyncio.Future[None] | None = None
        self.__ending: asyncio.Event | None = None

    # -- what others may ask ---------------------------------------------------------------------------

    @property
    def process_description(self) -> Executable:
        return self.__process_description

    @property
    def shell(self) -> bool:
        return self.__shell

    @property
    def emulate_tty(self) -> object:
        return self.__emulate_tty

    @property
    def output(self) -> Any:
        return self.__output

    @property
    def cached_output(self) -> bool:
        return self.__cached_output

    @property
    def sigterm_timeout(self) -> list[Substitution]:
        return self.__sigterm_timeout

    @property
    def sigkill_timeout(self) -> list[Substitution]:
        return self.__sigkill_timeout

    @property
    def return_code(self) -> int | None:
        """None while it runs; negative for a death by a signal."""
        return self.__return_code

    @property
    def process_details(self) -> dict[str, Any] | None:
        """None before it runs."""
        return None if self.__child is None else self._details()

    @property
    def name(self) -> str:
        return self.__process_description.final_name or "process"

    def get_stdout(self) -> bytes:
        return self._collected(1)

    def get_stderr(self) -> bytes:
        return self._collected(2)

    def get_asyncio_future(self) -> asyncio.Future[None] | None:
        return self.__completed_future

    def describe_conditional_sub_entities(self) -> list[tuple[str, list[LaunchDescriptionEntity]]]:
        if self.__on_exit is None or callable(self.__on_exit):
            return []
        return [("when the process exits", entities_of(self.__on_exit))]

    # -- start -----------------------------------------------------------------------------------------

    def prepare(self, context: LaunchContext) -> None:
        """Find out, now, what is to be run and where its output goes."""
        self.__process_description.prepare(context, self)
        output = self.__output
        chosen = output if isinstance(output, Mapping) else perform_substitutions(context, output)
        self.__loggers = get_output_loggers(self.name, chosen)

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        if self.__executed:
            raise RuntimeError(
                f"ExecuteLocal action '{self.name}': executed more than once: {self.describe()}"
            )
        self.__executed = True
        self.prepare(context)
        self.__timeouts = [
            _seconds(context, timeout) for timeout in (self.__sigterm_timeout, self.__sigkill_timeout)
        ]
        if context.is_shutdown or context.asyncio_loop is None:
            return None
        self.__completed_future = context.asyncio_loop.create_future()
        self.__ending = asyncio.Event()
        self._register_handlers(context)
        self.__task = context.asyncio_loop.create_task(self._live(context))
        return None

    async def _live(self, context: LaunchContext) -> None:
        try:
            await self._run_again_and_again(context)
        except Exception as error:  # noqa: BLE001  a program that cannot be started ends no launch
            text = f"exception occurred while executing process: {type(error).__name__}: {error}"
            self._logger.error(text)
        finally:
            self._end_of_life(context)

    async def _run_again_and_again(self, context: LaunchContext) -> None:
        retries = 0
        while True:
            await self._run_once(context)
            if not self._respawns(context, retries):
                return
            if await self._ended_during(float(perform_substitutions(context, self.__respawn_delay))):
                return
            retries += 1

    async def _run_once(self, context: LaunchContext) -> None:
        description = self.__process_description
        self.__outlet = Output(self.__loggers, self._formed, self.__cached_output)
        async with context._starting:  # in the order of the launch file, and told in that order
            if self._is_ending:
                return
            child = await Child.start(
                description.started_cmd,
                shell=self.__shell,
                cwd=description.final_cwd,
                env=description.final_env or {},
                emulate_tty=self._wants_tty(context),
                guard=context._guard,
            )
            self._on_started(context, child)
        try:
            child.listen(lambda fd, data: self._on_output(context, fd, data))
            self._on_exited(context, await child.wait())
        finally:
            child.kill()  # nothing is left behind when this task itself is cancelled

    def _on_started(self, context: LaunchContext, child: Child) -> None:
        self.__child = child
        self.__return_code = None
        self.__escalation = Escalation(self.name, self._logger, self._send)
        command = f": cmd '{self._command_line()}'" if self.__log_cmd else ""
        self._logger.info(f"process started with pid [{child.pid}]{command}")
        context.emit_event_sync(ProcessStarted(**self._details()))
        if self._is_ending:  # asked for while it was being started
            self._terminate(context, send_sigint=True)

    def _on_exited(self, context: LaunchContext, code: int) -> None:
        self.__escalation.cancel()
        self.__outlet.finish()
        self.__return_code = code
        pid = self.__child.pid if self.__child else "?"
        if code == 0:
            self._logger.info(f"process has finished cleanly [pid {pid}]")
        else:
            self._logger.error(
                f"process has died [pid {pid}, exit code {code}, cmd '{self._command_line()}']."
            )
        context.emit_event_sync(ProcessExited(returncode=code, **self._details()))

    def _on_output(self, context: LaunchContext, fd: int, data: bytes) -> None:
        self.__outlet.take(fd, data)
        event = (ProcessStdout if fd == 1 else ProcessStderr)(text=data, **self._details())
        if context.would_handle_event(event):
            context.emit_event_sync(event)

    def _respawns(self, context: LaunchContext, retries: int) -> bool:
        allowed = self.__respawn_max_retries < 0 or retries < self.__respawn_max_retries
        return allowed and not self._is_ending and not context.is_shutdown and _truth(context, self.__respawn)

    async def _ended_during(self, delay: float) -> bool:
        assert self.__ending is not None
        try:
            await asyncio.wait_for(self.__ending.wait(), delay)
        except asyncio.TimeoutError:
            return self._is_ending
        return True

    def _end_of_life(self, context: LaunchContext) -> None:
        for handler in self.__handlers:
            context.unregister_event_handler(handler)
        self.__handlers.clear()
        if self.__completed_future is not None and not self.__completed_future.done():
            self.__completed_future.set_result(None)

    # -- end -------------------------------------------------------------------------------------------

    def _register_handlers(self, context: LaunchContext) -> None:
        self.__handlers = [
            OnShutdown(on_shutdown=self._on_shutdown),
            _ForThis(self, ShutdownProcess, lambda event: self._end_child(context, True)),
            _ForThis(self, SignalProcess, lambda event: self._send(event.signal)),
            EventHandler(matcher=lambda event: self._is_input(event), entities=None),
        ]
        self.__handlers[-1].handle = self._on_input  # type: ignore[method-assign]
        for handler in self.__handlers:
            context.register_event_handler(handler)
        if self.__on_exit is not None:
            from launch.event_handlers.on_process_exit import OnProcessExit

            context.register_event_handler(OnProcessExit(target_action=self, on_exit=self.__on_exit))

    def _on_shutdown(self, event: Event, context: LaunchContext) -> None:
        by_terminal = isinstance(event, Shutdown) and event.due_to_sigint and not context.noninteractive
        self._end_child(context, send_sigint=not by_terminal)

    @property
    def _is_ending(self) -> bool:
        return self.__ending is not None and self.__ending.is_set()

    def _end_child(self, context: LaunchContext, send_sigint: bool) -> None:
        assert self.__ending is not None
        if not self._is_ending:
            self.__ending.set()
            self._terminate(context, send_sigint)

    def _terminate(self, context: LaunchContext, send_sigint: bool) -> None:
        """SIGINT, unless the terminal has sent it; what comes later if that does not help."""
        if self.__child is None or not self.__child.running:
            return
        if send_sigint:  # as an event: what a launch file does at a shutdown is done before
            wanted = SignalProcess(signal_number=signal.SIGINT, process_matcher=matches_action(self))
            context.emit_event_sync(wanted)
        self.__escalation.begin(*self.__timeouts)

    def _send(self, number: signal.Signals) -> None:
        if self.__child is None or not self.__child.running:
            self._logger.debug(f"signal '{number.name}' not sent to '{self.name}' because it has ended")
            return
        self._logger.info(f"sending signal '{number.name}' to process[{self.name}]")
        self.__child.send_signal(number)

    # -- details ---------------------------------------------------------------------------------------

    @property
    def _logger(self) -> Logger:
        return get_logger(self.name)

    def _details(self) -> dict[str, Any]:
        description = self.__process_description
        return {
            "action": self,
            "name": self.name,
            "cmd": description.final_cmd,
            "cwd": description.final_cwd,
            "env": description.final_env,
            "pid": self.__child.pid if self.__child else 0,
        }

    def _command_line(self) -> str:
        return " ".join(self.__process_description.final_cmd or ())

    def _formed(self, line: str) -> str:
        return self.__output_format.format(line=line, this=self)

    def _wants_tty(self, context: LaunchContext) -> bool:
        return _truth(context, context.launch_configurations.get("emulate_tty", self.__emulate_tty))

    def _collected(self, fd: int) -> bytes:
        if not self.__cached_output:
            raise RuntimeError("Output is not cached: the action needs cached_output=True")
        return bytes(self.__outlet.collected[fd])

    def _is_input(self, event: Event) -> bool:
        return isinstance(event, ProcessStdin) and event.action is self

    def _on_input(self, event: Event, context: LaunchContext) -> None:
        if isinstance(event, ProcessStdin) and self.__child is not None and self.__child.running:
            self.__child.write(event.text)


class _ForThis(BaseEventHandler):
    """A request that is about this process."""

    def __init__(self, action: ExecuteLocal, kind: type[ProcessTargetedEvent], do: Any) -> None:
        super().__init__(matcher=lambda event: isinstance(event, kind) and event.process_matcher(action))
        self._do = do

    def handle(self, event: Event, context: Any) -> None:
        self._do(event)


def _timeout(name: str, given: object | None) -> list[Substitution]:
    value = LaunchConfiguration(name, default=5) if given is None else given
    return texts(_number(value))


def _number(given: object) -> object:
    """A number is as good as a text that says it."""
    return str(given) if isinstance(given, int | float) else given


def _seconds(context: LaunchContext, given: list[Substitution]) -> str:
    """As it was written, as it is told so; anything but a number is told now, not when the launch ends."""
    text = perform_substitutions(context, given)
    float(text)
    return text


def _truth(context: LaunchContext, value: object) -> bool:
    return value if isinstance(value, bool) else evaluate_condition_expression(context, texts(value))
