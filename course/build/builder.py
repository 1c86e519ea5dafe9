"""Builds packages and what they need, or takes them from the store."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextlib import ExitStack, nullcontext
from dataclasses import dataclass

from course.build.budget import OURS, Bounds, Budget, claimed
from course.build.build_outcome import (
    BuildFailure,
    BuildOutcome,
    InstalledPackage,
    crowded,
    cycle,
    duplicate,
    package_missing,
    too_many,
    too_much,
    unreadable,
)
from course.build.colcon import SANITIZED, uses_cmake
from course.build.package_sources import SourcesChanged, TooMuch, content_key
from course.build.runner import Interrupt
from course.build.store import DiskFull, Store, storage
from course.build.workspace import MOST_PACKAGES, Package, Workspace
from course.errors import UsageError
from course.rosenv import Ros

TIME_LIMIT = 300.0  # seconds for one package
_WORKERS = 2  # compilers use the other cores
_ATTEMPTS = 3

Progress = Callable[[str], None]


def build(
    workspace: Workspace,
    names: Iterable[str],
    ros: Ros,
    store: Store,
    *,
    on_progress: Progress = lambda text: None,
    time_limit: float = TIME_LIMIT,
    interrupt: Interrupt | None = None,
    bounds: Bounds = OURS,
    keep: ExitStack | None = None,
    sanitized: bool = False,
) -> BuildOutcome:
    """Build the packages `names` of the workspace, and those of its packages on which they depend.

    What was built before from the same content is not built again. Mistakes of the learner, and exceeding
    `bounds`, are in the outcome's failure. What was built or found stays in the store until `keep` is
    closed (None: until this returns). Raises MissingHere and StorageError for what this machine
    lacks, and Interrupted when `interrupt` is set from another thread. on_progress may be called from other
    threads. sanitized: compile C++ with the address sanitizer, and with line numbers for its reports.
    """
    began = time.monotonic()
    names = tuple(names)
    budget = Budget(bounds)
    for _ in range(_ATTEMPTS):
        try:
            with Interrupt(interrupt) as stop:
                steps = _Build(workspace, ros, store, on_progress, time_limit, stop, budget, keep, sanitized)
                return steps.run(names, began)
        except SourcesChanged:
            workspace = workspace.scan_again()
        except DiskFull:  # somebody filled it for a moment, or claimed what this build needs
            if budget.again:
                raise
            budget.begin_again()
    what = f"Files in {workspace.source} keep changing while they are built."
    raise UsageError(what, "Wait until whatever writes them is done, then check again.")


@dataclass(frozen=True)
class _Build:
    workspace: Workspace
    ros: Ros
    store: Store
    on_progress: Progress
    time_limit: float
    stop: Interrupt
    budget: Budget
    keep: ExitStack | None
    sanitized: bool

    def run(self, names: Iterable[str], began: float) -> BuildOutcome:
        try:
            steps = build_order(self.workspace, names)
            if len(steps) > self.budget.bounds.packages:
                raise Unbuildable(too_many(steps[-1].package, len(steps), self.budget.bounds.packages))
            keys = self._keys(steps)
        except Unbuildable as error:
            return BuildOutcome((), error.failure, time.monotonic() - began)
        with nullcontext(self.keep) if self.keep is not None else ExitStack() as uses:
            for key in keys.values():
                uses.enter_context(self.store.in_use(key, self.stop))
            results: dict[str, InstalledPackage | BuildFailure] = dict(self._kept(steps, keys))
            missing = [step for step in steps if step.package.name not in results]
            if missing:
                with claimed(self.store, self.budget, self.stop, self._wait):
                    self._build_all(missing, keys, results)
                with storage(self.store.root):
                    self.store.prune_now_and_then()
        return _outcome(steps, results, time.monotonic() - began)

    def _wait(self) -> None:
        self.on_progress("Waiting for disk space that other builds use")

    def _keys(self, steps: Iterable[Step]) -> dict[str, str]:
        keys: dict[str, str] = {}
        for step in steps:
            needed = [keys[name] for name in step.after]
            try:
                with storage(step.package.folder):
                    keys[step.package.name] = content_key(
                        step.package.folder, self.workspace.home, needed, self._identity(step.package)
                    )
            except TooMuch as error:
                raise Unbuildable(too_much(step.package, error.largest)) from error
        return keys

    def _identity(self, package: Package) -> str:
        """Identifies what a build needs besides packages. Python cannot load interfaces with a sanitizer."""
        plain = not self.sanitized or not uses_cmake(package) or package.has_interfaces
        return self.ros.identity if plain else f"{self.ros.identity} {SANITIZED}"

    def _kept(self, steps: Iterable[Step], keys: Mapping[str, str]) -> Iterable[tuple[str, InstalledPackage]]:
        for step in steps:
            package, entry = step.package, self.store.entry(keys[step.package.name])
            if entry.is_complete():
                prefix = entry.prefix(package.name)
                self.budget.found(package.name, entry.size)
                yield package.name, InstalledPackage(package.name, package.source, prefix, True, 0.0)

    def _build_all(
        self,
        missing: list[Step],
        keys: Mapping[str, str],
        results: dict[str, InstalledPackage | BuildFailure],
    ) -> None:
        """Fill in `results`. Each step starts when its dependencies are built, until one fails."""
        running: dict[Future[InstalledPackage | BuildFailure], str] = {}
        with ThreadPoolExecutor(_WORKERS, "build") as pool:
            try:
                while True:
                    failed = any(isinstance(result, BuildFailure) for result in results.values())
                    for step in [] if failed else _ready(missing, results)[: _WORKERS - len(running)]:
                        missing.remove(step)
                        running[pool.submit(self._build_of(step, keys, results))] = step.package.name
                    if not running:
                        return
                    for future in wait(running, return_when=FIRST_COMPLETED).done:
                        results[running.pop(future)] = future.result()
            except BaseException:
                self.stop.set()  # the pool waits for its threads, and these for their programs
                raise

    def _build_of(
        self, step: Step, keys: Mapping[str, str], results: Mapping[str, InstalledPackage | BuildFailure]
    ) -> Callable[[], InstalledPackage | BuildFailure]:
        # Nothing to build is the usual case, and must be quick.
        from course.build.package_build import PackageBuild

        needed = [result for name in step.after if isinstance(result := results[name], InstalledPackage)]
        return PackageBuild(
            step.package,
            self.workspace,
            keys[step.package.name],
            tuple(keys[name] for name in step.after),
            tuple(package.prefix for package in needed),
            self.ros,
            self._identity(step.package),
            self.store,
            self.budget,
            self.time_limit,
            self.on_progress,
            self.stop,
        ).build


def _ready(missing: Iterable[Step], results: Mapping[str, object]) -> list[Step]:
    return [step for step in missing if all(name in results for name in step.after)]


def _outcome(
    steps: Iterable[Step], results: Mapping[str, InstalledPackage | BuildFailure], seconds: float
) -> BuildOutcome:
    in_order = [results[step.package.name] for step in steps if step.package.name in results]
    built = tuple(result for result in in_order if isinstance(result, InstalledPackage))
    failures = [result for result in in_order if isinstance(result, BuildFailure)]
    return BuildOutcome(built, failures[0] if failures else None, seconds)


@dataclass(frozen=True)
class Step:
    """One package to build, after `after`: the workspace packages it depends on, directly or not."""

    package: Package
    after: tuple[str, ...]


class Unbuildable(Exception):
    """Nothing can be built: something is wrong with the workspace itself."""

    def __init__(self, failure: BuildFailure) -> None:
        super().__init__(failure.feedback.summary)
        self.failure = failure


def build_order(workspace: Workspace, names: Iterable[str]) -> tuple[Step, ...]:
    """Steps for `names` and all workspace packages they depend on, dependencies first. Raises Unbuildable."""
    if len(workspace.packages) > MOST_PACKAGES:
        raise Unbuildable(crowded(workspace, MOST_PACKAGES))
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
        if workspace.named(dependency.name):  # otherwise it belongs to ROS or the system
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
