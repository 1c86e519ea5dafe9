"""The grader's own builds of packages that the learner also writes.

To hear messages of a type that the learner defines, the grading process loads our reference
build of that package, never the learner's. Whether the two define the same type is seen from
the type's hash on the wire.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from course.build import Interrupt, Store, Workspace, build
from course.content import Exercise
from course.errors import OurFault
from course.rosenv import Ros


def reference_packages(
    exercise: Exercise, ros: Ros, store: Store, on_progress: Callable[[str], None], stop: Interrupt
) -> tuple[Path, ...]:
    """Install prefixes of the exercise's `grader_packages`, built once a machine and kept.

    Raises OurFault when the course's own solution does not build.
    """
    prefixes: list[Path] = []
    for name in exercise.grader_packages:
        workspace = Workspace.scan(_solution_with(name, exercise.solution.parent))
        outcome = build(workspace, (name,), ros, store, on_progress=on_progress, interrupt=stop)
        if outcome.failure is not None:
            raise OurFault(f"the course's own {name} does not build: {outcome.failure.feedback.summary}")
        prefixes += outcome.prefixes
    return tuple(prefixes)


def _solution_with(package: str, solutions: Path) -> Path:
    """The workspace among the reference solutions that holds this package."""
    found = sorted(solutions.glob(f"*/*workspace/src/{package}/package.xml"))
    if not found:
        raise OurFault(f"no solution of the course holds the package {package}")
    return found[0].parents[2]
