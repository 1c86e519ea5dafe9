"""One check at a time, in a process that is ready before it is needed.

A check that is called off ends in order, with everything that it started; what is wanted next begins when
it has. Its successor's process is loading meanwhile.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import sys
import tempfile
from asyncio.subprocess import PIPE, Process
from collections.abc import AsyncIterator, Callable
from pathlib import Path
from typing import IO

import course
from course.content import Exercise
from course.feedback import Feedback
from course.grading.result import Result, Verdict
from course.watch.messages import message_from_line, task_to_line
from course.watch.model import Checked, Message, Said, Task

WORKER = "course.watch.worker"
# A check that is called off has this long to end what it started.
_END_TIME = 20.0
_LONGEST_LINE = 1 << 26
_LOG_LINES = 15


class Checks:
    """hear: gets what is said of the check that was started last. `serve` does the work."""

    def __init__(self, course: Path, home: Path, hear: Callable[[Message], None], *, namespaces: bool = True):
        self._course = course
        self._home = home
        self._hear = hear
        self._namespaces = namespaces
        self._number = 0
        self._wanted: Task | None = None
        self._wake = asyncio.Event()
        self._busy: Worker | None = None
        self._spare: asyncio.Task[Worker] | None = None

    def start(self, exercise: Exercise) -> int:
        """See `model.Checking`."""
        self.stop()
        if self._busy is not None and self._spare is None:
            self._spare = asyncio.ensure_future(Worker.start())
        self._number += 1
        self._wanted = Task(
            self._number, str(self._course), str(self._home), exercise.id, namespaces=self._namespaces
        )
        self._wake.set()
        return self._number

    def stop(self) -> None:
        """See `model.Checking`."""
        self._wanted = None
        if self._busy is not None and not self._busy.is_called_off:
            self._busy.call_off()

    async def serve(self) -> None:
        """Run what is started, until cancelled. Nothing that was started is left then."""
        worker = await Worker.start()
        try:
            while True:
                task = await self._next()
                if not await self._checked(worker, task):
                    await worker.end()
                    worker = await self._another()
        finally:
            await worker.end()
            if self._spare is not None:
                await (await self._spare).end()

    async def _next(self) -> Task:
        while self._wanted is None:
            self._wake.clear()
            await self._wake.wait()
        task, self._wanted = self._wanted, None
        return task

    async def _checked(self, worker: Worker, task: Task) -> bool:
        """Whether the worker can be used again."""
        self._busy = worker
        last: Message | None = None
        try:
            async for last in worker.check(task):
                if not worker.is_called_off:
                    self._hear(last)
        finally:
            self._busy = None
        if worker.is_called_off:
            return False
        if last is None or isinstance(last, Said):
            self._hear(Checked(task.number, worker.fallen(task)))
            return False
        return True

    async def _another(self) -> Worker:
        spare, self._spare = self._spare, None
        return await (spare or Worker.start())


class Worker:
    """The process. What it prints as errors is kept for the case that it falls over."""

    def __init__(self, process: Process, log: IO[str]) -> None:
        self._process = process
        self._log = log
        self.is_called_off = False

    @classmethod
    async def start(cls) -> Worker:
        with contextlib.ExitStack() as stack:
            log = stack.enter_context(tempfile.TemporaryFile("w+", errors="replace"))
            process = await asyncio.create_subprocess_exec(
                sys.executable,
                *("-m", WORKER),
                stdin=PIPE,
                stdout=PIPE,
                stderr=log,
                env=_environment(),
                # Ctrl+C and Ctrl+Z at the terminal are for us.
                start_new_session=True,
                limit=_LONGEST_LINE,
            )
            stack.pop_all()
        return cls(process, log)

    async def check(self, task: Task) -> AsyncIterator[Message]:
        """What it says, the last being the result; none is where it fell over, or was called off."""
        assert self._process.stdin is not None and self._process.stdout is not None
        with contextlib.suppress(ConnectionError):
            self._process.stdin.write(task_to_line(task).encode() + b"\n")
            await self._process.stdin.drain()
        while (message := await self._said(self._process.stdout)) is not None:
            yield message
            if not isinstance(message, Said):
                return

    async def _said(self, output: asyncio.StreamReader) -> Message | None:
        """None at its end, and for what makes no sense or is far too long."""
        try:
            line = await output.readline()
            return message_from_line(line.decode()) if line else None
        except (ValueError, KeyError, TypeError):
            return None

    def call_off(self) -> None:
        """Tell it to end what it does, and itself."""
        self.is_called_off = True
        with contextlib.suppress(ProcessLookupError):
            self._process.terminate()

    async def end(self) -> None:
        """Have it end in order; by force after some time."""
        if not self.is_called_off:
            self.call_off()
        try:
            await asyncio.wait_for(self._is_over(), _END_TIME)
        except asyncio.TimeoutError:
            self._process.kill()
            await self._is_over()
        self._log.close()

    async def _is_over(self) -> None:
        assert self._process.stdout is not None
        while await self._process.stdout.read(1 << 16):  # what nobody hears any more
            pass
        await self._process.wait()

    def fallen(self, task: Task) -> Result:
        """The result where it ended without one."""
        self._log.seek(0)
        fault = Feedback(
            "The process that checks ended without a verdict.",
            advice="This is the course's error, not yours. The attempt does not count. Try again.",
            details=tuple(self._log.read()[-8192:].splitlines()[-_LOG_LINES:]),
        )
        return Result(task.exercise, Verdict.OUR_ERROR, fault=fault)


def _environment() -> dict[str, str]:
    own = str(Path(course.__file__).parents[1])
    path = os.pathsep.join(part for part in (own, os.environ.get("PYTHONPATH")) if part)
    return {**os.environ, "PYTHONPATH": path}
