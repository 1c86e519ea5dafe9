"""Programs of the course's own among the learner's: with settings, or in a domain, that the learner chose.

They run confined like everything else: a setting may have them do what nobody expects.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property, partial
from pathlib import Path

from course.arena.domains import Domains
from course.arena.native_projects import NativeProjects
from course.arena.process import Process
from course.arena.shared_memory import files_in_memory
from course.errors import MissingHere
from course.evidence.events import Marked

_DOMAIN = "ROS_DOMAIN_ID"


class OwnPrograms(NativeProjects):
    """The part of an arena that starts them, and tells what they use."""

    def companion(
        self,
        file: Path,
        *arguments: str,
        name: str,
        env: Mapping[str, str] | None = None,
        own_memory: bool = False,
    ) -> Process:
        """Start a Python program of the course's (`file`) among the learner's, on a terminal of its own.

        own_memory: with a /dev/shm that it shares with nobody, as in a container. Raises MissingHere where
        that cannot be had.
        """
        if own_memory and self._shares_the_network:
            raise MissingHere(
                "This exercise needs namespaces, which this machine does not offer.",
                "`ros2course doctor` says what they lack here.",
            )
        start = partial(self._confined, own_memory=True) if own_memory else self._confined
        command = (self._python, self._handed(file), *arguments)
        return self._launch(name, command, {**self._programs(), **(env or {})}, start=start)

    def domain(self, number: int) -> int:
        """What a program must be given as its ROS_DOMAIN_ID to be in domain `number`; the arena is in 0.

        It is that number, unless others use the same network: see `Domains`.
        """
        return self._domains.at(number)

    def shared_memory(self, process: Process) -> tuple[str, ...]:
        """Names of the files in /dev/shm that the program, or one that it started, uses now; recorded."""
        found = files_in_memory(process.pid) if process.running else ()
        self.timeline.add(Marked(self.timeline.now(), memory_mark(process.name), " ".join(found)))
        return found

    @property
    def _shares_the_network(self) -> bool:
        return _DOMAIN in self._environment

    @cached_property
    def _domains(self) -> Domains:
        return Domains(int(self._environment[_DOMAIN]) if self._shares_the_network else None)


def memory_mark(name: str) -> str:
    """What the recording calls the look at the shared memory of the program `name`: `recording.marked`."""
    return f"shared memory of {name}"
