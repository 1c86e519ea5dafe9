"""Telling everyone who waits for a build that it is no longer wanted."""

from __future__ import annotations

import os
import select
from types import TracebackType


class Interrupted(Exception):
    """The build was called off before it was done."""


class Interrupt:
    """A flag that can be waited for together with file descriptors: one of `fds` is readable once it is set.

    Made for threads: KeyboardInterrupt reaches only the main one, which then sets this for the others.
    When `parent` is set, this one is, too.
    """

    def __init__(self, parent: Interrupt | None = None) -> None:
        end, self._other_end = os.pipe()
        self._end = end
        self.fds: tuple[int, ...] = (end, *(parent.fds if parent else ()))

    def __enter__(self) -> Interrupt:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.set()
        os.close(self._end)

    def set(self) -> None:
        """Wake all who wait, now and later. Setting it twice is fine."""
        end, self._other_end = self._other_end, -1
        if end != -1:
            os.close(end)

    def wait(self, seconds: float) -> None:
        """Wait that long, or raise Interrupted as soon as it is set."""
        if select.select(self.fds, [], [], seconds)[0]:
            raise Interrupted
