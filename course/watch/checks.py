"""One check at a time, in a process that is ready before it is needed.

A check that is called off ends in order, with everything that it started; only then does the next one begin.
Meanwhile, the next process is loading.
"""

from __future__ import annotations

import asyncio
import contextlib
import tempfile
from collections.abc import AsyncIterator, Callable
from pathlib import Path

from course.child import Child
from course.content import Exercise
from course.errors import DamagedData
from course.model import codec
from course.model.feedback import Feedback
from course.model.result import Result, Verdict
from course.watch.updates import Checked, CheckTask, Message, Said, SoFar

WORKER = "course.watch.check_worker"
# A check that is called off has this long to end what it started.
_END_TIME = 20.0
_LOG_LINES = 15


class Checks:
    """hear: called with messages about the check that was started last. `serve` does the work."""

    def __init__(self, course: Path, home: Path, hear: Callable[[Message], None], *, namespaces: bool = True):
        self._course = course
        self._home = home
        self._hear = hear
        self._namespaces = namespaces
        self._number = 0
        self._wanted: CheckTask | None = None
        self._wake = asyncio.Event()
        self._busy: CheckProcess | None = None
        self._spare: CheckProcess | None = None

    def start(self, exercise: Exercise) -> int:
        """Start a check, and call off a running one. Returns the number in its messages."""
        self.stop()
        if self._busy is not None and self._spare is None:
            self._spare = CheckProcess()
        self._number += 1
        self._wanted = CheckTask(
            self._number, str(self._course), str(self._home), exercise.id, namespaces=self._namespaces
        )
        self._wake.set()
        return self._number

    def stop(self) -> None:
        """Call off the running check, if any."""
        self._wanted = None
        if self._busy is not None and not self._busy.is_called_off:
            self._busy.call_off()

    async def serve(self) -> None:
        """Run the checks that are started, until cancelled. Ends everything that was started."""
        worker = CheckProcess()
        try:
            while True:
                task = await self._next()
                if not await self._checked(worker, task):
                    await worker.end()
                    worker, self._spare = self._spare or CheckProcess(), None
        finally:
            await worker.end()
            if self._spare is not None:
                await self._spare.end()

    async def _next(self) -> CheckTask:
        while self._wanted is None:
            self._wake.clear()
            await self._wake.wait()
        task, self._wanted = self._wanted, None
        return task

    async def _checked(self, worker: CheckProcess, task: CheckTask) -> bool:
        """Run the check. Return whether the worker can be used again."""
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
        if last is None or isinstance(last, Said | SoFar):
            result = last.result if isinstance(last, SoFar) else worker.fallen(task)
            self._hear(Checked(task.number, result))
            return False
        return True


class CheckProcess:
    """The process. Its error output is kept in case it crashes."""

    def __init__(self) -> None:
        self.is_called_off = False
        self._ending: asyncio.Future[None] | None = None
        with contextlib.ExitStack() as stack:
            self._log = stack.enter_context(tempfile.TemporaryFile("w+", errors="replace"))
            self._child = Child(WORKER, log=self._log)
            stack.pop_all()

    async def check(self, task: CheckTask) -> AsyncIterator[Message]:
        """Its messages, of which the last is the result. There is none if it crashed or was called off."""
        self._child.tell(task)
        with contextlib.suppress(DamagedData):  # a line that is far too long, or not a message
            while (lines := await self._read()) is not None:
                for line in lines:
                    message: Message = codec.from_json(line, Message, "this line")
                    yield message
                    if not isinstance(message, Said | SoFar):
                        return

    async def _read(self) -> list[bytes] | None:
        loop, ready = asyncio.get_running_loop(), asyncio.Event()
        loop.add_reader(self._child.answers, ready.set)
        try:
            await ready.wait()
        finally:
            loop.remove_reader(self._child.answers)
        return self._child.read()

    def call_off(self) -> None:
        """Tell it to end its check, and itself."""
        self.is_called_off = True
        self._child.process.terminate()

    async def end(self) -> None:
        """End it in order, or by force after some time. This continues even if the caller is cancelled."""
        # Python 3.11's `wait_for` loses a cancellation if its result arrives at the same moment.
        self._ending = self._ending or asyncio.ensure_future(self._end())
        await asyncio.shield(self._ending)

    async def _end(self) -> None:
        if not self.is_called_off:
            self.call_off()
        try:
            await asyncio.wait_for(self._is_over(), _END_TIME)
        except asyncio.TimeoutError:
            self._child.process.kill()
        await asyncio.to_thread(self._child.close, _END_TIME)
        self._log.close()

    async def _is_over(self) -> None:
        over = False
        while not over:
            with contextlib.suppress(DamagedData):  # nobody reads these lines any more
                over = await self._read() is None

    def fallen(self, task: CheckTask) -> Result:
        """The result if it ended without one."""
        self._log.seek(0)
        fault = Feedback(
            "The process that checks ended without a verdict.",
            advice="This is the course's error, not yours. The attempt does not count. Try again.",
            details=tuple(self._log.read()[-8192:].splitlines()[-_LOG_LINES:]),
        )
        return Result(task.exercise, Verdict.OUR_ERROR, fault=fault)
