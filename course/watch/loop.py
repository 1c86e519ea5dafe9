"""Connects saves, keys, signals and checks, and shows the results."""

from __future__ import annotations

import asyncio
import contextlib
import signal
import time
from collections.abc import Callable, Coroutine, Iterable, Iterator
from pathlib import Path
from typing import Any

from course.content import Exercise
from course.errors import UsageError
from course.home import CourseHome, is_home
from course.watch.checks import Checks
from course.watch.saves import saves
from course.watch.screen import Screen
from course.watch.session import Session
from course.watch.terminal import Terminal
from course.watch.updates import Begun, Event, Key, Learner, Saved, SignalCame, Tick

# While a check runs, its seconds are counted.
_SECOND = 1.0
_ENDINGS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
_OTHERS = (signal.SIGWINCH, signal.SIGTSTP, signal.SIGCONT)


def watch(
    learner: Learner, begun: Begun, course: Path, typed: Callable[[str], str], *, namespaces: bool
) -> int:
    """Watch until the learner ends it. Returns the number of the signal that ended it; 0 for a key.

    Afterwards, the terminal is as before, and no check is running. Raises UsageError if the course home is
    gone, MissingHere if this machine cannot report saves, and any error from storing a result.
    """
    return asyncio.run(_Watch(learner, begun, course, typed, namespaces=namespaces).run())


class _Watch:
    def __init__(
        self, learner: Learner, begun: Begun, course: Path, typed: Callable[[str], str], *, namespaces: bool
    ) -> None:
        self._learner = learner
        self._begun = begun
        self._course = course
        self._namespaces = namespaces
        self._screen = Screen(typed)
        self._events: asyncio.Queue[Event] = asyncio.Queue()
        self._following = 0

    async def run(self) -> int:
        home = CourseHome(self._learner.home)
        checks = Checks(self._course, home.path, self._events.put_nowait, namespaces=self._namespaces)
        with self._signals(), Terminal() as self._terminal:
            self._session = Session(self._learner, checks, self._begun, lambda: self._following, self._ask)
            self._terminal.on_keys(self._read_keys)
            try:
                # Listening comes first, so that no save after the first screen is missed.
                return await _first_of(
                    self._listen(home), self._until_ended(), checks.serve(), self._count(home)
                )
            finally:
                self._terminal.ignore_keys()

    async def _until_ended(self) -> int:
        self._show()
        ended_by = 0
        while not (ended_by or self._session.over):
            event = await self._events.get()
            if not isinstance(event, SignalCame):
                self._session.hear(event)
            elif event.number in _ENDINGS:
                ended_by = event.number
            else:
                self._obey(event.number)
            if self._events.empty():
                self._show()
        self._session.leave()
        self._show()
        return ended_by

    def _show(self, *, anew: bool = False) -> None:
        columns, lines = self._terminal.size()
        frame = self._screen.draw(self._session.look, columns, lines, time.monotonic())
        self._following = frame.following
        self._terminal.show(frame.lines, anew=anew)

    # ------------------------------------------------------------------------------- where events come from

    def _read_keys(self) -> None:
        keys = self._terminal.pressed()
        if keys is None:
            self._terminal.ignore_keys()
            self._events.put_nowait(SignalCame(signal.SIGHUP))
        for key in keys or "":
            self._events.put_nowait(Key(key))

    async def _listen(self, home: CourseHome) -> int:
        async for files in saves(home):
            self._events.put_nowait(Saved(files))
        raise _gone(home)

    async def _count(self, home: CourseHome) -> int:
        while is_home(home.path):
            await asyncio.sleep(_SECOND)
            self._events.put_nowait(Tick())
        raise _gone(home)

    @contextlib.contextmanager
    def _signals(self) -> Iterator[None]:
        """Queue signals: they are handled between two events, never while the terminal is handed over."""
        self._hear((*_ENDINGS, *_OTHERS))
        try:
            yield
        finally:
            self._ignore((*_ENDINGS, *_OTHERS))

    def _hear(self, numbers: Iterable[int]) -> None:
        for number in numbers:
            asyncio.get_running_loop().add_signal_handler(number, self._events.put_nowait, SignalCame(number))

    def _ignore(self, numbers: Iterable[int]) -> None:
        for number in numbers:
            asyncio.get_running_loop().remove_signal_handler(number)

    # ----------------------------------------------------------------------------------- what signals do

    def _obey(self, number: int) -> None:
        if number == signal.SIGTSTP:
            self._pause()
        elif number == signal.SIGCONT:
            self._terminal.take()
        self._show(anew=True)

    def _pause(self) -> None:
        """Pause with the terminal restored, like any program after Ctrl+Z. A check continues."""
        with self._terminal.lent():
            self._ignore([signal.SIGTSTP])
            signal.raise_signal(signal.SIGTSTP)
            self._hear([signal.SIGTSTP])

    def _ask(self, exercise: Exercise) -> bool:
        """Ask the questions on the restored terminal. False after Ctrl+C."""
        self._terminal.ignore_keys()
        with self._terminal.lent():
            self._ignore((*_ENDINGS, signal.SIGTSTP))
            try:
                self._learner.ask(exercise)
                return True
            except KeyboardInterrupt:
                return False
            finally:
                self._hear((*_ENDINGS, signal.SIGTSTP))
                self._terminal.on_keys(self._read_keys)


def _gone(home: CourseHome) -> UsageError:
    return UsageError(f"The course home is gone: {home.path}", "Create one: ros2course init")


async def _first_of(*parts: Coroutine[Any, Any, int | None]) -> int:
    """Return or raise the result of the first that ends. Cancel the others and wait for them."""
    tasks = [asyncio.ensure_future(part) for part in parts]
    try:
        await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
        return next(task.result() for task in tasks if task.done()) or 0
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
