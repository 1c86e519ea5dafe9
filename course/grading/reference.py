"""The grader's own builds of packages that the learner also writes.

To receive messages of a type that the learner defines, the recording process loads our reference
build of that package, never the learner's. The type's hash on the wire shows whether both define
the same type.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from pathlib import Path

from course.arena.mystery_nodes import TALK
from course.build import Interrupt, Store, Workspace, build
from course.content import Exercise
from course.errors import OurFault
from course.rosenv import Ros, node_environment, prepare

# In a classroom, learners must not see each other's mysteries.
_OWN_MACHINE = {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}


@contextmanager
def workers() -> Iterator[tuple[ThreadPoolExecutor, Interrupt]]:
    """Threads for builds, which are stopped if this thread is interrupted."""
    with Interrupt() as stop, ThreadPoolExecutor(2, "check") as pool:
        try:
            yield pool, stop
        except BaseException:
            stop.set()
            raise


def reference_packages(
    exercise: Exercise,
    ros: Ros,
    store: Store,
    on_progress: Callable[[str], None],
    stop: Interrupt,
    keep: ExitStack,
) -> tuple[Path, ...]:
    """Install prefixes of the exercise's `grader_packages`, built once per machine and kept.

    They stay in the store at least until `keep` is closed.
    Raises OurFault if the course's own solution does not build.
    """
    prefixes: list[Path] = []
    for name in exercise.grader_packages:
        workspace = Workspace.scan(_solution_with(name, exercise.solution.parent))
        outcome = build(workspace, (name,), ros, store, on_progress=on_progress, interrupt=stop, keep=keep)
        if outcome.failure is not None:
            raise OurFault(f"the course's own {name} does not build: {outcome.failure.feedback.summary}")
        prefixes += outcome.prefixes
    return tuple(prefixes)


def _solution_with(package: str, solutions: Path) -> Path:
    """The workspace in the reference solutions that contains this package."""
    found = sorted(solutions.glob(f"*/*workspace/src/{package}/package.xml"))
    if not found:
        raise OurFault(f"no solution of the course contains the package {package}")
    return found[0].parents[2]


def play_environment(
    exercise: Exercise,
    ros: Ros,
    keep: ExitStack,
    *,
    store: Store | None = None,
    on_progress: Callable[[str], None] = lambda text: None,
    environ: Mapping[str, str] | None = None,
) -> dict[str, str]:
    """The environment for the mystery's nodes: the exercise's `grader_packages`, in the caller's ROS domain.

    Only this machine sees them, unless the caller's `ROS_AUTOMATIC_DISCOVERY_RANGE` says otherwise.
    Builds those packages the first time; they are not removed before `keep` is closed. Raises what
    `check_exercise` raises.
    """
    environ = os.environ if environ is None else environ
    prepare(ros)
    with workers() as (pool, stop):
        made = pool.submit(reference_packages, exercise, ros, store or Store(), on_progress, stop, keep)
        prefixes = made.result()
    talk = {name: environ[name] for name in TALK if name in environ}
    return {**node_environment(ros, prefixes, environ), **_OWN_MACHINE, **talk}
