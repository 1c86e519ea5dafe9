"""Building packages: what is asked for and what it needs, from the store where it can."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass

from course.build.interrupt import Interrupt
from course.build.job import Job, SourcesChanged
from course.build.key import content_key
from course.build.outcome import BuildFailure, BuildOutcome, BuiltPackage
from course.build.plan import Step, Unbuildable, plan
from course.build.refusal import too_much
from course.build.sources import TooMuch
from course.build.store import Store, storage
from course.build.workspace import Workspace
from course.errors import UsageError
from course.rosenv import Ros

TIME_LIMIT = 300.0  # seconds for one package
_WORKERS = 2  # a compiler uses what is left
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
) -> BuildOutcome:
    """Build the packages `names` of the workspace and the packages of it that they declare to need.

    What was built before from the same content is not built again. What the learner did wrong is in the
    outcome's failure. Raises MissingHere and StorageError for what this machine lacks, and Interrupted
    when `interrupt` is set from another thread. on_progress may be called from other threads.
    """
    began = time.monotonic()
    names = tuple(names)
    for _ in range(_ATTEMPTS):
        try:
            with Interrupt(interrupt) as stop:
                return _Build(workspace, ros, store, on_progress, time_limit, stop).run(names, began)
        except SourcesChanged:
            workspace = workspace.scan_again()
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

    def run(self, names: Iterable[str], began: float) -> BuildOutcome:
        try:
            steps = plan(self.workspace, names)
            keys = self._keys(steps)
        except Unbuildable as error:
            return BuildOutcome((), error.failure, time.monotonic() - began)
        results: dict[str, BuiltPackage | BuildFailure] = dict(self._kept(steps, keys))
        missing = [step for step in steps if step.package.name not in results]
        if missing:
            self._build_all(missing, keys, results)
            with storage(self.store.root):
                self.store.prune()
        return _outcome(steps, results, time.monotonic() - began)

    def _keys(self, steps: Iterable[Step]) -> dict[str, str]:
        keys: dict[str, str] = {}
        for step in steps:
            needed = [keys[name] for name in step.after]
            try:
                with storage(step.package.folder):
                    keys[step.package.name] = content_key(
                        step.package.folder, self.workspace.home, needed, self.ros.identity
                    )
            except TooMuch as error:
                raise Unbuildable(too_much(step.package, error.largest)) from error
        return keys

    def _kept(self, steps: Iterable[Step], keys: Mapping[str, str]) -> Iterable[tuple[str, BuiltPackage]]:
        for step in steps:
            package, entry = step.package, self.store.entry(keys[step.package.name])
            if entry.is_complete():
                prefix = entry.prefix(package.name)
                yield package.name, BuiltPackage(package.name, package.source, prefix, True, 0.0)

    def _build_all(
        self,
        missing: list[Step],
        keys: Mapping[str, str],
        results: dict[str, BuiltPackage | BuildFailure],
    ) -> None:
        """Fill in `results`: each step as soon as what it needs is built, until one fails."""
        from course.build.one import build_one  # nothing to build is the usual case, and must be quick

        running: dict[Future[BuiltPackage | BuildFailure], str] = {}
        with ThreadPoolExecutor(_WORKERS, "build") as pool:
            try:
                while True:
                    failed = any(isinstance(result, BuildFailure) for result in results.values())
                    for step in [] if failed else _ready(missing, results)[: _WORKERS - len(running)]:
                        missing.remove(step)
                        job = self._job(step, keys, results)
                        running[pool.submit(build_one, job, self.stop)] = step.package.name
                    if not running:
                        return
                    for future in wait(running, return_when=FIRST_COMPLETED).done:
                        results[running.pop(future)] = future.result()
            except BaseException:
                self.stop.set()  # the pool waits for its threads, and these for their programs
                raise

    def _job(
        self, step: Step, keys: Mapping[str, str], results: Mapping[str, BuiltPackage | BuildFailure]
    ) -> Job:
        needed = [result for name in step.after if isinstance(result := results[name], BuiltPackage)]
        return Job(
            step.package,
            self.workspace,
            keys[step.package.name],
            tuple(keys[name] for name in step.after),
            tuple(package.prefix for package in needed),
            self.ros,
            self.store,
            self.time_limit,
            self.on_progress,
        )


def _ready(missing: Iterable[Step], results: Mapping[str, object]) -> list[Step]:
    return [step for step in missing if all(name in results for name in step.after)]


def _outcome(
    steps: Iterable[Step], results: Mapping[str, BuiltPackage | BuildFailure], seconds: float
) -> BuildOutcome:
    in_order = [results[step.package.name] for step in steps if step.package.name in results]
    built = tuple(result for result in in_order if isinstance(result, BuiltPackage))
    failures = [result for result in in_order if isinstance(result, BuildFailure)]
    return BuildOutcome(built, failures[0] if failures else None, seconds)
