"""A toy exercise whose program is any Python text, graded by the real grading process."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.arena.enclosure import enclosure
from course.evidence.packages import BuiltPackage, BuiltPackages
from course.grading.channel import Judgement
from course.grading.job import Job
from course.grading.supervisor import Supervisor
from course.rosenv import find_ros, node_environment

GRADER = """
from course.grading.author import Grader
from course.grading.expect.programs import expect_running, expect_clean_interrupt

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

Grade = Callable[..., Judgement]


@pytest.fixture
def toy_job(tmp_path: Path) -> Callable[..., Job]:
    """A job for a program and a grader given as texts."""

    def make(program: str, grader: str = GRADER) -> Job:
        ros = find_ros()
        prefix = tmp_path / "prefix"
        executable = prefix / "lib" / "toy" / "program"
        executable.parent.mkdir(parents=True)
        executable.write_text(f"#!{ros.python}\n{program}", encoding="utf-8")
        executable.chmod(0o755)
        module = tmp_path / "toy_grader.py"
        module.write_text(grader, encoding="utf-8")
        package = BuiltPackage("toy", "ros2_tutorial_workspace/src/toy", str(prefix), ("program",))
        return Job(
            exercise="01-toy",
            grader=str(module),
            home=str(tmp_path),
            roots=(),
            packages=BuiltPackages((package,)),
            environment=node_environment(ros, (prefix,)),
            python=str(ros.python),
        )

    return make


@pytest.fixture(params=["namespaces", "domain"])
def grade(request: pytest.FixtureRequest, toy_job: Callable[..., Job]) -> Grade:
    """Grade the toy in both kinds of enclosure."""

    def run(program: str, grader: str = GRADER, time_limit: float = 30.0) -> Judgement:
        job = toy_job(program, grader)
        with enclosure(namespaces=request.param == "namespaces") as where:
            if where.kind != request.param:
                pytest.skip(f"this machine gives no {request.param}: {where.missing}")
            environment = {**job.environment, **where.environment}
            job = Job(**{**vars(job), "environment": environment})
            with Supervisor(where, node_environment(find_ros())) as supervisor:
                return supervisor.grade(job, time_limit, lambda text: None)

    return run
