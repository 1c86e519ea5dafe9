"""A toy exercise whose program is any Python text, graded by the real processes."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import pytest

from course.content import open_course
from course.evidence.packages import BuiltPackage, BuiltPackages
from course.grading.judge.judges import Judge
from course.grading.protocol import RecordingTask
from course.grading.supervisor import ForkServer, Supervisor
from course.isolation.levels import Isolation, isolated
from course.model import replace
from course.model.feedback import Feedback
from course.model.result import CheckResult, Doubt
from course.rosenv import find_ros, node_environment

GRADER = """
from course.api import Grader, expect_clean_interrupt, expect_running

toy = Grader("01-toy")

@toy.scenario
def run_it(arena):
    program = arena.run("toy", "program")
    arena.until(lambda: arena.printed("go"), timeout=30, while_running=program)
    arena.interrupt(program)

@toy.check("starts", "it starts")
def starts(recording):
    expect_running(recording, "program")

@toy.check("interrupt", "Ctrl+C ends it", needs="starts")
def interrupt(recording):
    expect_clean_interrupt(recording, "program")
"""


@dataclass(frozen=True)
class Graded:
    """The result of a recording, and of judging it if there is one."""

    checks: tuple[CheckResult, ...] = ()
    fault: Feedback | None = None
    doubt: Doubt | None = None
    missing: bool = False


Grade = Callable[..., Graded]


@contextlib.contextmanager
def supervised(where: Isolation, environment: Mapping[str, str]) -> Iterator[Supervisor]:
    """One recording process, with a fork server of its own."""
    with (
        contextlib.closing(ForkServer()) as fork_server,
        Supervisor(where, environment, fork_server) as supervisor,
    ):
        yield supervisor


def graded(supervisor: Supervisor, task: RecordingTask, time_limit: float = 30.0) -> Graded:
    """Record, then judge, as `check` does, an exercise that is in no course."""
    recorded = supervisor.record(task, time_limit, lambda text: None)
    if recorded.fault is not None:
        return Graded((), recorded.fault, recorded.doubt, recorded.missing)
    exercise = replace(open_course().exercise("02-script"), id=task.exercise, grader=Path(task.grader))
    with contextlib.closing(Judge()) as judge:
        file = Path(f"/proc/{os.getpid()}/fd/{supervisor.recording.fileno()}")
        judgment = judge.judge(exercise, file)
    return Graded(judgment.checks, judgment.fault, judgment.doubt)


def lay_toy(folder: Path, program: str, grader: str = GRADER) -> RecordingTask:
    """A job in this folder, for a program and a grader given as texts."""
    ros = find_ros()
    prefix = folder / "prefix"
    executable = prefix / "lib" / "toy" / "program"
    executable.parent.mkdir(parents=True)
    executable.write_text(f"#!{ros.python}\n{program}", encoding="utf-8")
    executable.chmod(0o755)
    module = folder / "toy_grader.py"
    module.write_text(grader, encoding="utf-8")
    package = BuiltPackage("toy", "ros2_tutorial_workspace/src/toy", str(prefix), ("program",))
    return RecordingTask(
        exercise="01-toy",
        grader=str(module),
        home=str(folder),
        roots=(),
        packages=BuiltPackages((package,)),
        environment=node_environment(ros, (prefix,)),
        python=str(ros.python),
    )


@pytest.fixture
def toy_job(tmp_path: Path) -> Callable[..., RecordingTask]:
    return partial(lay_toy, tmp_path)


@pytest.fixture(params=["namespaces", "domain"])
def grade(request: pytest.FixtureRequest, toy_job: Callable[..., RecordingTask]) -> Grade:
    """Grade the toy in both kinds of isolation."""

    def run(program: str, grader: str = GRADER, time_limit: float = 30.0) -> Graded:
        job = toy_job(program, grader)
        with isolated(namespaces=request.param == "namespaces") as where:
            if where.level != request.param:
                pytest.skip(f"this machine gives no {request.param}: {where.missing}")
            environment = {**job.environment, **where.environment}
            job = replace(job, environment=environment)
            with supervised(where, node_environment(find_ros())) as supervisor:
                return graded(supervisor, job, time_limit)

    return run
