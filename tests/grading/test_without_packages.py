"""Exercises that are no nodes: their own files as evidence, programs in a copy of the home, no ROS at all."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from course.arena.enclosure import enclosure
from course.content import open_course
from course.evidence.packages import BuiltPackages
from course.grading.channel import Judgement
from course.grading.check import check_exercise
from course.grading.job import Job
from course.grading.result import Outcome, Verdict
from course.grading.supervisor import Supervisor
from course.rosenv import find_ros, node_environment

pytestmark = pytest.mark.slow

GRADER = """
import sys
from course.feedback import NotApplicable
from course.grading.author import Grader
from course.grading.expect.files import expect_file
from course.grading.expect.shell import expect_ran

toy = Grader("01-toy", builds=None, ros=False)

@toy.scenario
def look_around(arena):
    with arena.shell() as shell:
        shell.run("say_hello; touch made.txt; ls -1")

@toy.check("file", "the file is there")
def file(recording):
    expect_file(recording, "folder/x.txt")

@toy.check("says", "the alias prints hello")
def says(recording):
    printed = expect_ran(recording, "say_hello; touch made.txt; ls -1").printed
    assert printed == ("hello", "folder", "made.txt"), printed

@toy.check("index", "needs more than there is")
def index(recording):
    if not recording.local:
        raise NotApplicable("It is about your own machine.")

@toy.check("after", "comes after that", needs="index")
def after(recording):
    pass
"""

Run = Callable[..., Judgement]


@pytest.fixture
def home(tmp_path: Path) -> Path:
    home = tmp_path / "home"
    (home / "folder").mkdir(parents=True)
    (home / "folder/x.txt").write_text("x")
    (home / "secret.txt").write_text("not looked at")
    (home / ".bashrc").write_text("alias say_hello='echo hello'\n")
    return home


@pytest.fixture
def run(tmp_path: Path, home: Path) -> Run:
    def grade(local: bool = True) -> Judgement:
        module = tmp_path / "toy_grader.py"
        module.write_text(GRADER, encoding="utf-8")
        environment = node_environment(find_ros())
        job = Job(
            exercise="01-toy",
            grader=str(module),
            home=str(home),
            roots=(),
            packages=BuiltPackages(),
            environment=environment,
            python="/nowhere/python3",
            looks_at=("folder",),
            plain={"PATH": "/usr/bin:/bin"},
            local=local,
        )
        with enclosure() as where, Supervisor(where, environment) as supervisor:
            return supervisor.grade(job, 30.0, lambda text: None)

    return grade


def test_files_and_a_shell_in_a_copy_of_the_home(run: Run, home: Path) -> None:
    judgement = run()
    assert judgement.fault is None
    assert {check.id: check.outcome for check in judgement.checks} == dict.fromkeys(
        ("file", "says", "index", "after"), Outcome.PASSED
    ), judgement.checks
    assert sorted(path.name for path in home.iterdir()) == [".bashrc", "folder", "secret.txt"]


def test_what_a_submission_lacks_does_not_apply(run: Run) -> None:
    by_id = {check.id: check for check in run(local=False).checks}
    assert by_id["index"].outcome is by_id["after"].outcome is Outcome.NOT_APPLICABLE
    assert by_id["after"].skipped_because == "It is about your own machine."
    assert by_id["says"].outcome is Outcome.PASSED


def test_an_exercise_about_the_learners_machine(small_course: Path, home: Path) -> None:
    exercise = replace(open_course(small_course).exercise("04-light"), local_only=True, bonus=True)
    result = check_exercise(exercise, home, ros=find_ros(), local=False)
    assert (result.verdict, result.bonus, result.checks) == (Verdict.NOT_APPLICABLE, True, ())
    assert "your own machine" in result.notes[0]
