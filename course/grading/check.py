"""One check from the learner's files to the verdict.

Builds what the exercise needs, starts the grading process in the enclosure that this machine
allows, and waits for its judgement within the time limit. Whatever goes wrong on our side
becomes an «our error» result: the learner is never blamed for it.
"""

from __future__ import annotations

import contextlib
import sys
import time
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import course
from course.arena.acts import acts_file, read_acts
from course.arena.containment import Containment, Places, containment
from course.arena.play_module import seed_for
from course.arena.sandbox.plan import Plan
from course.arena.sandbox.view import hidden, shown
from course.build import BuildOutcome, Interrupt, Store, Workspace, build
from course.build.underlay import provide
from course.content import Exercise
from course.errors import MissingHere, OurFault
from course.grading.channel import Judgement
from course.grading.job import Job
from course.grading.load import runs_programs
from course.grading.outcome import is_spoilt
from course.grading.packages import as_evidence
from course.grading.quiz.check import check_quiz, with_questions
from course.grading.reference import reference_packages
from course.grading.result import Result, Timing, Verdict, not_applicable, verdict_of
from course.grading.supervisor import Supervisor
from course.grading.workers import workers
from course.rosenv import Ros, node_environment, places_of, plain_environment, prepare

STATE = ".ros2course"

ON_OWN_MACHINE = "It is about your own machine, and no part of what is handed in."

Progress = Callable[[str], None]
Judge = Callable[[Exercise, Path], Judgement]


def check_exercise(
    exercise: Exercise,
    home: Path,
    *,
    ros: Ros | None,
    store: Store | None = None,
    on_progress: Progress = lambda text: None,
    namespaces: bool = True,
    evidence: Path | None = None,
    local: bool = True,
    seed: int | None = None,
    judge: Judge | None = None,
) -> Result:
    """Grade `exercise` as it stands in the course home `home`.

    Nothing in `home` is written. on_progress gets short texts, from this thread or others.
    evidence: keep the recording in this MCAP file.
    namespaces: False grades in a ROS domain of its own even where namespaces would work.
    local: False for a submission: what is about the learner's own machine is then not applicable.
    ros: None only where `load.runs_programs` says that none is needed. seed: the learner's own (see
    `CourseHome.seed`), or one made of their submission's name; needed for mysteries.
    judge: judges the recording kept in `evidence`, in place of the grading process (see `rejudge.Beside`).
    Raises MissingHere and StorageError for what this machine lacks; KeyboardInterrupt passes
    through after everything that was started has ended.
    """
    if exercise.local_only and not local:
        return not_applicable(exercise.id, ON_OWN_MACHINE, bonus=exercise.bonus)
    if not runs_programs(exercise):
        return check_quiz(exercise, home, seed)
    if ros is None:
        raise OurFault(f"{exercise.id} cannot be graded without a ROS")
    began = time.monotonic()
    prepare(ros)
    store = store or Store()
    places = _places(exercise, home, ros, store, evidence)
    with containment(places, namespaces=namespaces) as where, workers() as (pool, stop):
        learners = pool.submit(_build, exercise, home, ros, store, on_progress, stop, local)
        reference = pool.submit(reference_packages, exercise, ros, store, on_progress, stop).result()
        # Loads while the learner's packages are still being built.
        with Supervisor(where.around, node_environment(ros, reference)) as supervisor:
            outcome = learners.result()
            built = time.monotonic()
            job = _job(exercise, home, ros, outcome, where, evidence, local, seed)
            job = replace(job, judge=judge is None)
            recorded = supervisor.grade(job, exercise.time_limit, on_progress)
        if recorded.missing and recorded.fault is not None:
            raise MissingHere(recorded.fault.summary, recorded.fault.advice)
        judgement = _judged(recorded, judge, exercise, evidence)
        if is_spoilt(judgement.checks):
            on_progress("watching your program once more")
            with Supervisor(where.around, node_environment(ros, reference)) as another:
                recorded = another.grade(job, exercise.time_limit, on_progress)
            judgement = _judged(recorded, judge, exercise, evidence)
    timing = Timing(
        build=round(built - began, 3),
        evidence=round(judgement.evidence, 3),
        total=round(time.monotonic() - began, 3),
        lag=round(judgement.lag, 3),
        cpu=round(judgement.cpu, 3),
    )
    result = _result(exercise, judgement, timing, where.around.kind, where.around.missing)
    return with_questions(result, exercise, home, seed)


def _judged(recorded: Judgement, judge: Judge | None, exercise: Exercise, evidence: Path | None) -> Judgement:
    if recorded.judged or judge is None or evidence is None:
        return recorded
    said = judge(exercise, evidence)
    return replace(recorded, checks=said.checks, fault=said.fault, judged=True)


def _build(
    exercise: Exercise,
    home: Path,
    ros: Ros,
    store: Store,
    on_progress: Progress,
    stop: Interrupt,
    local: bool,
) -> BuildOutcome:
    workspace = Workspace.scan(home / exercise.workspace, home, trusted=local)
    provide(workspace, exercise.packages, ros, on_progress=on_progress, interrupt=stop)
    return build(workspace, exercise.packages, ros, store, on_progress=on_progress, interrupt=stop)


def _job(
    exercise: Exercise,
    home: Path,
    ros: Ros,
    outcome: BuildOutcome,
    where: Containment,
    evidence: Path | None,
    local: bool,
    seed: int | None,
) -> Job:
    packages = as_evidence(outcome)
    extra = where.around.environment
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
        looks_at=(*exercise.files, *exercise.looks_at),
        plain={**plain_environment(ros), **extra},
        local=local,
        sandbox=_sandbox(where, ros, environment, exercise, home, local),
        **_mystery(exercise, home, seed),
    )


def _sandbox(
    where: Containment,
    ros: Ros,
    environment: Mapping[str, str],
    exercise: Exercise,
    home: Path,
    local: bool,
) -> Plan | None:
    # A virtual environment and what `colcon build` installed work in their own place only. Of a submission
    # neither is looked at.
    own = [*(file.parent for file in home.glob("*/pyvenv.cfg")), home / exercise.workspace] if local else []
    visible = shown(ros, environment, own)
    return where.plan(visible, hidden(visible))


def _places(exercise: Exercise, home: Path, ros: Ros, store: Store, evidence: Path | None) -> Places:
    """What the grading process reads and writes."""
    if evidence:
        with contextlib.suppress(OSError):  # saving it says so
            evidence.parent.mkdir(parents=True, exist_ok=True)
    engine = Path(course.__file__).parents[1]
    with contextlib.suppress(OSError):  # building says so
        store.root.mkdir(parents=True, exist_ok=True)
    pythons = (Path(sys.prefix), Path(sys.base_prefix), *places_of(ros))
    read = (*pythons, engine, exercise.grader.parents[1], exercise.solution.parent, home, store.root)
    return Places(tuple(dict.fromkeys(read)), (evidence.parent,) if evidence else ())


def _mystery(exercise: Exercise, home: Path, seed: int | None) -> dict[str, Any]:
    """What the grading process is told of the exercise's mystery."""
    if exercise.play is None or seed is None:
        return {}
    acts = read_acts(acts_file(home / STATE, exercise.id))
    return {"seed": seed_for(exercise.id, seed), "acts": tuple((act.name, act.detail) for act in acts)}


def _result(
    exercise: Exercise, judgement: Judgement, timing: Timing, kind: str, missing: str | None
) -> Result:
    verdict = Verdict.OUR_ERROR if judgement.fault else verdict_of(judgement.checks)
    notes = (missing,) if missing else ()
    return Result(
        exercise.id, verdict, judgement.checks, timing, judgement.fault, kind, notes, bonus=exercise.bonus
    )
