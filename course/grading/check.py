"""One check from the learner's files to the verdict.

Builds what the exercise needs, starts the grading process in the enclosure that this machine
allows, and waits for its judgement within the time limit. Whatever goes wrong on our side
becomes an «our error» result: the learner is never blamed for it.
"""

from __future__ import annotations

import contextlib
import time
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from course.arena.enclosure import enclosure
from course.build import BuildOutcome, Interrupt, Store, Workspace, build
from course.content import Exercise
from course.grading.channel import Judgement
from course.grading.job import Job
from course.grading.packages import as_evidence
from course.grading.reference import reference_packages
from course.grading.result import Result, Timing, Verdict, verdict_of
from course.grading.supervisor import Supervisor
from course.rosenv import Ros, node_environment, prepare

WORKSPACE = "ros2_tutorial_workspace"

Progress = Callable[[str], None]


def check_exercise(
    exercise: Exercise,
    home: Path,
    *,
    ros: Ros,
    store: Store | None = None,
    on_progress: Progress = lambda text: None,
    namespaces: bool = True,
    evidence: Path | None = None,
) -> Result:
    """Grade `exercise` as it stands in the course home `home`.

    Nothing in `home` is written. on_progress gets short texts, from this thread or others.
    evidence: keep the recording in this MCAP file.
    namespaces: False grades in a ROS domain of its own even where namespaces would work.
    Raises MissingHere and StorageError for what this machine lacks; KeyboardInterrupt passes
    through after everything that was started has ended.
    """
    began = time.monotonic()
    prepare(ros)
    store = store or Store()
    with enclosure(namespaces=namespaces) as where, _workers() as (pool, stop):
        learners = pool.submit(_build, exercise, home, ros, store, on_progress, stop)
        reference = pool.submit(reference_packages, exercise, ros, store, on_progress, stop).result()
        # Loads while the learner's packages are still being built.
        with Supervisor(where, node_environment(ros, reference)) as supervisor:
            outcome = learners.result()
            built = time.monotonic()
            job = _job(exercise, home, ros, outcome, where.environment, evidence)
            judgement = supervisor.grade(job, exercise.time_limit, on_progress)
    timing = Timing(
        build=round(built - began, 3),
        evidence=round(judgement.evidence, 3),
        total=round(time.monotonic() - began, 3),
    )
    return _result(exercise, judgement, timing, where.kind, where.missing)


@contextlib.contextmanager
def _workers() -> Iterator[tuple[ThreadPoolExecutor, Interrupt]]:
    """Threads for builds, which are called off when this one is interrupted."""
    with Interrupt() as stop, ThreadPoolExecutor(2, "check") as pool:
        try:
            yield pool, stop
        except BaseException:
            stop.set()
            raise


def _build(
    exercise: Exercise, home: Path, ros: Ros, store: Store, on_progress: Progress, stop: Interrupt
) -> BuildOutcome:
    workspace = Workspace.scan(home / WORKSPACE, home)
    return build(workspace, exercise.packages, ros, store, on_progress=on_progress, interrupt=stop)


def _job(
    exercise: Exercise,
    home: Path,
    ros: Ros,
    outcome: BuildOutcome,
    extra: Mapping[str, str],
    evidence: Path | None,
) -> Job:
    packages = as_evidence(outcome)
    environment = {**node_environment(ros, outcome.prefixes), **extra}
    roots = (*(package.source for package in packages.built), *exercise.files)
    return Job(
        exercise=exercise.id,
        grader=str(exercise.grader),
        home=str(home),
        roots=tuple(dict.fromkeys(roots)),
        packages=packages,
        environment=environment,
        python=str(ros.python),
        evidence=str(evidence) if evidence else None,
    )


def _result(
    exercise: Exercise, judgement: Judgement, timing: Timing, kind: str, missing: str | None
) -> Result:
    verdict = Verdict.OUR_ERROR if judgement.fault else verdict_of(judgement.checks)
    notes = (missing,) if missing else ()
    return Result(exercise.id, verdict, judgement.checks, timing, judgement.fault, kind, notes)
