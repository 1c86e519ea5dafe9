"""Runs what a package's build runs: foreign code, which sees and writes no more than it needs."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path

from course.arena.sandbox.limits import BUILD
from course.arena.sandbox.once import Confinement, confinement
from course.arena.sandbox.sandbox import hand_over
from course.arena.sandbox.watchdog import Watchdog
from course.build.interrupt import Interrupt
from course.build.job import Job
from course.build.process import Ended, run
from course.build.store import Entry
from course.build.usage import Usage

Run = Callable[..., Ended]


@contextlib.contextmanager
def confined(job: Job, entry: Entry, env: Mapping[str, str], stop: Interrupt) -> Iterator[Run]:
    """Yields what runs a command: `run(command, cwd, output, time_limit)`. No process of it lives on.

    What it wrote is another user's, and whatever that user liked: see `seal`.
    """
    writable = _writable(entry)
    with confinement(job.ros, env, entry.path, writable, job.overlays, BUILD) as place:
        for folder in writable:
            hand_over(folder, place.who.user)

        def run_here(command: Sequence[str], cwd: Path, output: Path, time_limit: float) -> Ended:
            with place.entrance() as (prefix, descriptors):
                return run(
                    [*prefix, *(("env", "-C", str(cwd)) if prefix else ()), *command],
                    cwd=cwd,
                    env=env,
                    output=output,
                    time_limit=time_limit,
                    interrupt=stop,
                    descriptors=descriptors,
                    breach=_breach(place, written(entry)),
                )

        yield run_here


def written(entry: Entry) -> Usage:
    return Usage(_writable(entry), BUILD.scratch)


def _writable(entry: Entry) -> tuple[Path, ...]:
    return (entry.src, entry.build, entry.install)


def _breach(place: Confinement, usage: Usage) -> Callable[[int], str | None]:
    def look(pid: int) -> str | None:
        return usage.look() or Watchdog(BUILD, place.who.control_groups, pid, lambda: (0, 1)).look()

    return look
