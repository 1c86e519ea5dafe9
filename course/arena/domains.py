"""ROS domains for programs of a scenario, also where the machine's own domains are in use by others."""

from __future__ import annotations

import contextlib

from course.arena.enclosure import free_domain


class Domains:
    """around: the domain that the arena was given; None where it has a network of its own."""

    def __init__(self, around: int | None) -> None:
        self._around = around
        self._known = {0: around}
        self._claims = contextlib.ExitStack()

    def at(self, number: int) -> int:
        """What a program must be given to be in the domain `number`, from 0, which is the arena's.

        On a network that others use, too, a free domain takes its place: in the one of that number there may
        be other checks, or a robot. It is held until `close`. Raises MissingHere when all are taken.
        """
        if self._around is None:
            return number
        found = self._known.get(number)
        if found is None:
            found = self._known[number] = self._claims.enter_context(free_domain())
        return found

    def close(self) -> None:
        """Others may have what was held."""
        self._claims.close()
