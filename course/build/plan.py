"""Which packages a build needs, in which order; or why there is no such order."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from course.build.outcome import BuildFailure
from course.build.refusal import cycle, duplicate, package_missing, unreadable
from course.build.workspace import Package, Workspace


@dataclass(frozen=True)
class Step:
    """One package to build, after `after`: the workspace packages it depends on, directly or not."""

    package: Package
    after: tuple[str, ...]


class Unbuildable(Exception):
    """There is nothing to run yet: the workspace itself is not right."""

    def __init__(self, failure: BuildFailure) -> None:
        super().__init__(failure.feedback.summary)
        self.failure = failure


def plan(workspace: Workspace, names: Iterable[str]) -> tuple[Step, ...]:
    """Steps for `names` and all workspace packages they depend on, dependencies first. Raises Unbuildable."""
    steps: dict[str, Step] = {}
    for name in names:
        _add(name, workspace, steps, ())
    return tuple(steps.values())


def _add(name: str, workspace: Workspace, steps: dict[str, Step], above: tuple[str, ...]) -> None:
    if name in above:
        raise Unbuildable(cycle(workspace, above[above.index(name) :]))
    if name in steps:
        return
    package = _the_only(name, workspace)
    needed: dict[str, None] = {}
    for dependency in package.dependencies:
        if workspace.named(dependency.name):  # else it is one of ROS, or of the system
            _add(dependency.name, workspace, steps, (*above, name))
            needed.update(dict.fromkeys((*steps[dependency.name].after, dependency.name)))
    steps[name] = Step(package, tuple(needed))


def _the_only(name: str, workspace: Workspace) -> Package:
    found = workspace.named(name)
    if not found:
        raise Unbuildable(package_missing(workspace, name))
    if len(found) > 1:
        raise Unbuildable(duplicate(found))
    if found[0].fault:
        raise Unbuildable(unreadable(found[0], found[0].fault))
    return found[0]
