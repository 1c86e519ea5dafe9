"""Exercises without nodes: their files as evidence, programs in a copy of the home, no ROS at all."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.build import Store
from course.content import open_course
from course.errors import OurFault
from course.evidence.packages import BuiltPackages
from course.grading.check import Request, check_exercise
from course.grading.protocol import RecordingTask
from course.grading.trial import lay_solution
from course.isolation import Level, view
from course.isolation.levels import isolated, obstacle_to
from course.model import replace
from course.model.result import Outcome, Verdict
from course.rosenv import find_ros, node_environment

from .conftest import Graded, graded, supervised

pytestmark = pytest.mark.slow
REPO = Path(__file__).parents[2]

GRADER = """
import sys
from course.api import Grader, NotApplicable, expect_file, expect_ran

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
        raise NotApplicable("It is about your own computer.")

@toy.check("after", "comes after that", needs="index")
def after(recording):
    pass
"""

Run = Callable[..., Graded]


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
    def grade(local: bool = True) -> Graded:
        module = tmp_path / "toy_grader.py"
        module.write_text(GRADER, encoding="utf-8")
        environment = node_environment(find_ros())
        job = RecordingTask(
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
        with isolated() as where, supervised(where, environment) as supervisor:
            return graded(supervisor, job)

    return grade


def test_files_and_a_shell_in_a_copy_of_the_home(run: Run, home: Path) -> None:
    judgment = run()
    assert judgment.fault is None
    assert {check.id: check.outcome for check in judgment.checks} == dict.fromkeys(
        ("file", "says", "index", "after"), Outcome.PASSED
    ), judgment.checks
    assert sorted(path.name for path in home.iterdir()) == [".bashrc", "folder", "secret.txt"]


def test_what_a_submission_lacks_does_not_apply(run: Run) -> None:
    by_id = {check.id: check for check in run(local=False).checks}
    assert by_id["index"].outcome is by_id["after"].outcome is Outcome.NOT_APPLICABLE
    assert by_id["after"].skipped_because == "It is about your own computer."
    assert by_id["says"].outcome is Outcome.PASSED


def test_an_exercise_about_the_learners_machine(small_course: Path, home: Path) -> None:
    exercise = replace(open_course(small_course).exercise("04-light"), local_only=True, bonus=True)
    result = check_exercise(Request(exercise, home, ros=find_ros(), local=False))
    assert (result.verdict, result.bonus, result.checks) == (Verdict.NOT_APPLICABLE, True, ())
    assert "your own computer" in result.notes[0]


@pytest.mark.parametrize("linked", [False, True])
@pytest.mark.parametrize("part", ["graders", "solutions", "chapters"])
def test_a_course_that_submissions_can_read_builds_and_grades_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, part: str, linked: bool
) -> None:
    if obstacle := obstacle_to(Level.CONTAINED):
        pytest.skip(f"not exercised here: nothing is hidden ({obstacle})")
    monkeypatch.setattr(view, "SYSTEM", (*view.SYSTEM, REPO / part))
    root = tmp_path / "link" if linked else REPO
    if linked:
        root.symlink_to(REPO)
    course, home, store = open_course(root), tmp_path / "handed-in", Store(tmp_path / "store")
    exercise = course.exercise("07-simplest-package")
    lay_solution(course, exercise, home)
    with pytest.raises(OurFault, match="files, which submissions can read"):
        check_exercise(Request(exercise, home, ros=find_ros(), store=store, local=False))
    assert not any(store.root.iterdir())
