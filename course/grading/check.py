"""Grades one exercise, from the learner's files to the verdict.

Builds what the exercise needs, and starts the recording process as isolated as this machine allows. Waits
for the recording up to the time limit, and has another process judge it. Anything that goes wrong on our side
becomes the result "our error": the learner is never blamed for it.
"""

from __future__ import annotations

import contextlib
import functools
import os
import sys
import tempfile
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import course
from course.arena.command_lines import installed_executables
from course.arena.mystery_module import log_file, read_log, seed_for
from course.build import BuildOutcome, Interrupt, Store, Workspace, build
from course.build.budget import SUBMISSION
from course.build.underlay_build import provide
from course.content import Exercise, open_course
from course.content.layout import STATE
from course.errors import CourseError, MissingHere, OurFault, StorageError
from course.evidence.mcap_file import keep as keep_recording
from course.evidence.packages import BuiltPackage, BuiltPackages
from course.explain.cpp_crashes import NO_LINE
from course.explain.engine import failed_with
from course.explain.observed import UNKNOWN
from course.grading import trial
from course.grading.attempts import concluded, deserves_another, doubt_of
from course.grading.judge.judges import Judge
from course.grading.load import runs_programs
from course.grading.protocol import Judgment, RecordingOutcome, RecordingTask
from course.grading.quiz.questions import check_quiz, with_questions
from course.grading.reference import reference_packages, workers
from course.grading.supervisor import ForkServer, Supervisor
from course.grading.trial_answers import SEED
from course.isolation import Level
from course.isolation.isolation_plan import IsolationPlan
from course.isolation.levels import Isolation, MachinePlaces, isolated
from course.isolation.view import view
from course.model import replace
from course.model.result import Result, Timing, Verdict, not_applicable, verdict_of
from course.rosenv import Ros, node_environment, places_of, plain_environment, prepare

ON_OWN_MACHINE = "It is about your own computer, and not part of what you submit."

Progress = Callable[[str], None]


@dataclass(frozen=True)
class Request:
    """What to grade, and how. Nothing is written to the course home `home`.

    ros: may be None only if `load.runs_programs` is false for the exercise.
    namespaces: False to grade in a separate ROS domain even where namespaces would work.
    evidence: keep the recording in this MCAP file.
    local: False for a submission: an exercise about the learner's own machine is then not applicable.
    seed: the learner's own (see `CourseHome.seed`), or one made from their submission's name; needed for
    mysteries. on_progress: gets short texts, from the caller's thread or others. looks_for_cause: whether
    to run a second time if checks failed without a proven cause; by default, if the result is not in
    doubt. so_far: gets the result before that run, which only changes advice.
    """

    exercise: Exercise
    home: Path
    ros: Ros | None = None
    store: Store = field(default_factory=Store)
    namespaces: bool = True
    evidence: Path | None = None
    local: bool = True
    seed: int | None = None
    on_progress: Progress = lambda text: None
    looks_for_cause: Callable[[Result], bool] = lambda result: doubt_of(result) is None
    so_far: Callable[[Result], None] = lambda result: None


class Helpers:
    """Processes that serve one grading after another: one forks recorders, one judges. Close them.

    fork_server: one that the caller closes.
    """

    def __init__(self, fork_server: ForkServer | None = None) -> None:
        self._shared = fork_server is not None
        self.fork_server = fork_server or ForkServer()
        self.judge = Judge()

    def close(self) -> None:
        self.judge.close()
        if not self._shared:
            self.fork_server.close()


def check_exercise(request: Request, fork_server: ForkServer | None = None) -> Result:
    """Grade an exercise as it is now, and again if there is doubt: see `attempts`.

    fork_server: one to reuse. Raises what `attempt_exercise` raises.
    """
    with contextlib.closing(Helpers(fork_server)) as helpers:
        attempt, result = 1, attempt_exercise(request, helpers)
        while deserves_another(result, attempt):
            request.on_progress("watching your program again")
            attempt, result = attempt + 1, attempt_exercise(request, helpers)
        return concluded(result, attempt, request.exercise, lambda: solution_passes(request, helpers))


def solution_passes(request: Request, helpers: Helpers) -> bool:
    """Whether the course's own solution can be judged on this machine, and passes."""
    exercise = request.exercise
    with tempfile.TemporaryDirectory(prefix="ros2course-") as home:
        trial.lay_solution(open_course(exercise.grader.parents[1]), exercise, Path(home))
        own = Request(
            exercise,
            Path(home),
            ros=request.ros,
            store=request.store,
            namespaces=request.namespaces,
            local=False,
            seed=SEED,
        )
        return attempt_exercise(own, helpers).verdict is Verdict.PASSED


def attempt_exercise(request: Request, helpers: Helpers) -> Result:
    """Grade once. The result may contain doubts, which `attempts` resolves.

    Raises MissingHere and StorageError for what this machine lacks; KeyboardInterrupt passes
    through after everything that was started has ended.
    """
    exercise, ros = request.exercise, request.ros
    if exercise.local_only and not request.local:
        return not_applicable(exercise.id, ON_OWN_MACHINE, bonus=exercise.bonus)
    if not runs_programs(exercise):
        return check_quiz(exercise, request.home, request.seed)
    if ros is None:
        raise OurFault(f"{exercise.id} cannot be graded without ROS")
    began = time.monotonic()
    prepare(ros)
    helpers.fork_server.start(node_environment(ros))
    with (
        contextlib.ExitStack() as keep,
        isolated(_places(request, ros), namespaces=request.namespaces) as where,
        workers() as (pool, stop),
    ):
        if where.level is Level.CONTAINED and not request.local:
            _require_hidden(exercise, ros)
        learners = pool.submit(_build, request, ros, stop, keep)
        reference = pool.submit(
            reference_packages, exercise, ros, request.store, request.on_progress, stop, keep
        ).result()
        # It starts while the learner's packages are still being built.
        with Supervisor(where, node_environment(ros, reference), helpers.fork_server) as supervisor:
            outcome = learners.result()
            built = time.monotonic()
            helpers.judge.prepare(exercise)
            task = _task(request, ros, outcome, where)
            recorded = supervisor.record(task, exercise.time_limit, request.on_progress)
            if recorded.fault is None:
                _keep(supervisor, request)
            judgment = _judged(recorded, supervisor, helpers.judge, request)
            timing = Timing(
                build=round(built - began, 3),
                evidence=round(recorded.seconds, 3),
                total=round(time.monotonic() - began, 3),
                lag=round(recorded.lag, 3),
                cpu=round(recorded.cpu, 3),
            )
            result = _result(exercise, judgment, timing, where)
            result = with_questions(result, exercise, request.home, request.seed)
            if _lacks_a_cause(result, task) and request.looks_for_cause(result):
                request.so_far(result)

                def again() -> RecordingTask:
                    if not any(failed_with(check, NO_LINE) for check in result.checks):
                        return task
                    rebuilt = pool.submit(_build, request, ros, stop, keep, sanitized=True)
                    return _task(request, ros, rebuilt.result(), where)

                return _with_causes(result, again, supervisor, helpers, request, where)
    return result


def _lacks_a_cause(result: Result, task: RecordingTask) -> bool:
    """Whether Python ran and a check failed without a known cause, or C++ crashed on an unknown line."""
    built = (f"{task.home}/{package.source}/setup.py" for package in task.packages.built)
    python = any(map(os.path.exists, built)) or not task.packages.built
    asking = (NO_LINE, UNKNOWN) if python else (NO_LINE,)
    return result.fault is None and any(failed_with(check, *asking) for check in result.checks)


def _with_causes(
    result: Result,
    task: Callable[[], RecordingTask],
    judged: Supervisor,
    helpers: Helpers,
    request: Request,
    where: Isolation,
) -> Result:
    """Run the scenario again while observing the learner's programs from inside, only to improve the advice.

    The notes are added to the recording that was judged, which is judged again. Only its advice counts.
    """
    request.on_progress("looking for the cause: your program runs again")
    left = max(request.exercise.time_limit - result.timing.evidence, 1.0)
    again = Judgment(())
    # Whatever goes wrong here, the verdict stands.
    with (
        contextlib.suppress(CourseError),
        Supervisor(where, judged.environment, helpers.fork_server, judged.recording) as supervisor,
    ):
        recorded = supervisor.record(replace(task(), observed=True), left, request.on_progress)
        again = _judged(recorded, supervisor, helpers.judge, request)
        if again.fault is None:
            _keep(supervisor, request)
    found = {check.id: check.feedback for check in again.checks if check.feedback}
    checks = tuple(
        replace(check, feedback=replace(check.feedback, advice=cause.advice, where=cause.where))
        if failed_with(check, UNKNOWN, NO_LINE) and check.feedback and (cause := found.get(check.id))
        else check
        for check in result.checks
    )
    return replace(result, checks=checks)


def _judged(recorded: RecordingOutcome, recorder: Supervisor, judge: Judge, request: Request) -> Judgment:
    if recorded.missing and recorded.fault is not None:
        raise MissingHere(recorded.fault.summary, recorded.fault.advice)
    if recorded.fault is not None:
        return Judgment((), recorded.fault, recorded.doubt)
    # The recording's file has no name.
    return judge.judge(request.exercise, Path(f"/proc/{os.getpid()}/fd/{recorder.recording.fileno()}"))


def _keep(recorder: Supervisor, request: Request) -> None:
    if request.evidence is not None:
        try:
            keep_recording(recorder.recording, request.evidence)
        except StorageError as error:  # no reason to withhold the verdict
            request.on_progress(error.what)


def _build(
    request: Request, ros: Ros, stop: Interrupt, keep: contextlib.ExitStack, *, sanitized: bool = False
) -> BuildOutcome:
    exercise = request.exercise
    workspace = Workspace.scan(request.home / exercise.workspace, request.home, trusted=request.local)
    provide(workspace, exercise.packages, ros, on_progress=request.on_progress, interrupt=stop)
    return build(
        workspace,
        exercise.packages,
        ros,
        request.store,
        on_progress=request.on_progress,
        interrupt=stop,
        bounds=SUBMISSION,
        keep=keep,
        sanitized=sanitized,
    )


def _task(request: Request, ros: Ros, outcome: BuildOutcome, where: Isolation) -> RecordingTask:
    exercise, packages = request.exercise, as_evidence(outcome)
    extra = where.environment
    environment = {**node_environment(ros, outcome.prefixes), **extra}
    roots = (*(package.source for package in packages.built), *exercise.files)
    return RecordingTask(
        exercise=exercise.id,
        grader=str(exercise.grader),
        home=str(request.home),
        roots=tuple(dict.fromkeys(roots)),
        packages=packages,
        environment=environment,
        python=str(ros.python),
        looks_at=(*exercise.files, *exercise.looks_at),
        plain={**plain_environment(ros), **extra},
        local=request.local,
        sandbox=_sandbox(where, ros, environment, request),
        **_mystery(request),
    )


def as_evidence(outcome: BuildOutcome) -> BuiltPackages:
    """The packages with the executables that are actually installed, and the build failure, if any."""
    built = tuple(
        BuiltPackage(
            package.name,
            package.source,
            str(package.prefix),
            installed_executables(package.prefix, package.name),
        )
        for package in outcome.packages
    )
    return BuiltPackages(built, outcome.failure.feedback if outcome.failure else None)


def _sandbox(
    where: Isolation, ros: Ros, environment: Mapping[str, str], request: Request
) -> IsolationPlan | None:
    # A virtual environment, and what `colcon build` installed, only work in their original place. For a
    # submission, neither is used.
    home = request.home
    own = [*(file.parent for file in home.glob("*/pyvenv.cfg")), home / request.exercise.workspace]
    return where.sandbox(view(ros, environment, own if request.local else []))


def _require_hidden(exercise: Exercise, ros: Ros) -> None:
    """Raise OurFault if builds and programs of a submission could read the course."""
    readable = _readable((exercise.grader, exercise.solution, exercise.folder), ros)
    if readable:
        what = f"{readable} is among the system's files, which submissions can read."
        raise OurFault(what, "Move the course to its own folder, such as one in your home.")


@functools.cache
def _readable(places: tuple[Path, ...], ros: Ros) -> Path | None:
    seen = view(ros, node_environment(ros))
    return next((place for one in places for place in (one, one.resolve()) if seen.shows(place)), None)


def _places(request: Request, ros: Ros) -> MachinePlaces:
    store, exercise = request.store.root, request.exercise
    engine = Path(course.__file__).parents[1]
    with contextlib.suppress(OSError):  # the build reports it
        store.mkdir(parents=True, exist_ok=True)
    pythons = (Path(sys.prefix), Path(sys.base_prefix), *places_of(ros))
    read = (*pythons, engine, exercise.grader.parents[1], exercise.solution.parent, request.home, store)
    return MachinePlaces(tuple(dict.fromkeys(read)))


def _mystery(request: Request) -> dict[str, Any]:
    exercise = request.exercise
    if exercise.play is None or request.seed is None:
        return {}
    acts = read_log(log_file(request.home / STATE, exercise.id))
    told = tuple((act.name, act.detail) for act in acts)
    return {"seed": seed_for(exercise.id, request.seed), "acts": told}


def _result(exercise: Exercise, judgment: Judgment, timing: Timing, around: Isolation) -> Result:
    return Result(
        exercise.id,
        Verdict.OUR_ERROR if judgment.fault else verdict_of(judgment.checks),
        judgment.checks,
        timing,
        judgment.fault,
        around.level.value,
        (around.missing,) if around.missing else (),
        exercise.bonus,
        judgment.doubt,
    )
