"""Runs programs of others apart from this machine: `isolation.start(plan, command)`.

isolation_plan.py  what a program may see, write and use up; travels to the grading process
bubblewrap.py      namespaces: the only module that names the program that makes them
none.py            the same without namespaces, for tests and where there are none
levels.py          which level this machine offers, and what is chosen for a check and a build
identity.py        a user id and control groups that nobody else has, for as long as a grading takes
view.py            which files are to be seen
sandbox.py         programs of a submission, in namespaces that are held; launcher.py starts them there
watchdog.py        sees when a submission uses up more than it may
linux.py           system calls that Python has no function for; system_calls.py: those that are refused

Another isolation (Docker, say) is one more module with the functions of `Backend`. `ISOLATION` names the
one in use.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any, Protocol

from course.isolation import bubblewrap, none
from course.isolation.isolation_plan import Holder, IsolatedProcess, IsolationPlan, Level, Restriction

__all__ = ["ISOLATION", "Backend", "IsolationPlan", "Level", "start"]


class Backend(Protocol):
    """What a module of an isolation has."""

    def program(self) -> str:
        """The file whose change means that everything has to be tried again."""

    def obstacle(self, level: Level) -> str | None:
        """Why this level cannot be had here, in one line with what to do; None when it can."""

    def build_obstacle(self) -> str | None:
        """Why commands of a build cannot be kept apart here; None when they can."""

    def restriction(self) -> Restriction | None:
        """The first setting of this machine that prevents it; None if it must be something else."""

    def prefix(self, plan: IsolationPlan) -> tuple[str, ...]:
        """What stands before a command that sees the whole machine (`IsolationPlan.machine`)."""

    def with_own_memory(self, command: Sequence[str]) -> tuple[str, ...]:
        """The command, with a /dev/shm that it shares with nobody, and the rest of the machine as it is."""

    def start(
        self, plan: IsolationPlan, command: Sequence[str], **options: Any
    ) -> AbstractContextManager[IsolatedProcess]:
        """See `start`."""

    def hold(self, plan: IsolationPlan, scratch: Path | None = None) -> AbstractContextManager[Holder]:
        """Keep namespaces in which nothing happens, until the end; then all in them is killed.

        scratch: a folder of their own, in memory, where the machine is hidden. Raises OurFault when it cannot
        be done.
        """


# What is used wherever there is a plan.
ISOLATION: Backend = bubblewrap


def start(
    plan: IsolationPlan | None, command: Sequence[str], **options: Any
) -> AbstractContextManager[IsolatedProcess]:
    """Start the command in a session of its own, as the plan says; without isolation if there is none.

    options: for subprocess.Popen. At the end of the context the whole session is killed; with a plan, also
    what had left it. Raises OurFault when something does not end.
    """
    if plan is None:
        return none.start(None, command, **options)
    return ISOLATION.start(plan, command, **options)
