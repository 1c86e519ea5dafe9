"""Runs other people's programs isolated from this machine: `isolation.start(plan, command)`.

isolation_plan.py  what a program may see, write, and use; sent to the grading process
bubblewrap.py      in namespaces made by bubblewrap; the only module that names it
none.py            without namespaces, for tests and for machines that have none
levels.py          which level this machine offers, and which one a check or a build gets
identity.py        a user id and control groups for one grading, used by nobody else
view.py            which files are visible
sandbox.py         a submission's programs, in namespaces kept open for them; launcher.py starts them there
watchdog.py        notices when a submission exceeds a limit
linux.py           system calls that Python has no function for; system_calls.py: those that are refused

To add another isolation (Docker, say), write one more module with the functions of `Backend`. `ISOLATION`
is the one in use.
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
    """What each isolation module provides."""

    def program(self) -> str:
        """The program that isolates, whose levels are tested again when its file changes."""

    def obstacle(self, level: Level) -> str | None:
        """Why this level is not available here, in one line with what to do; None if it is."""

    def build_obstacle(self) -> str | None:
        """Why build commands cannot be confined here; None if they can."""

    def restriction(self) -> Restriction | None:
        """The first setting of this machine that prevents isolation; None if the cause is something else."""

    def prefix(self, plan: IsolationPlan) -> tuple[str, ...]:
        """What to put in front of a command that sees the whole machine (`IsolationPlan.machine`)."""

    def with_own_memory(self, command: Sequence[str]) -> tuple[str, ...]:
        """The command, with its own private /dev/shm and the rest of the machine as it is."""

    def start(
        self, plan: IsolationPlan, command: Sequence[str], **options: Any
    ) -> AbstractContextManager[IsolatedProcess]:
        """See `start`."""

    def hold(self, plan: IsolationPlan, scratch: Path | None = None) -> AbstractContextManager[Holder]:
        """Keep empty namespaces open until the context ends; then kill everything in them.

        scratch: their own folder, in memory, if the machine is hidden. Raises OurFault if that fails.
        """


# Used wherever there is a plan.
ISOLATION: Backend = bubblewrap


def start(
    plan: IsolationPlan | None, command: Sequence[str], **options: Any
) -> AbstractContextManager[IsolatedProcess]:
    """Start the command in its own session, as the plan says; without isolation if there is no plan.

    options: for subprocess.Popen. When the context ends, the whole session is killed; with a plan, also
    anything that left it. Raises OurFault if something does not end.
    """
    if plan is None:
        return none.start(None, command, **options)
    return ISOLATION.start(plan, command, **options)
