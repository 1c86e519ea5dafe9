"""The real command on real Dask workers: one of them killed, the command killed, stopped, and resumed."""

from __future__ import annotations

import os
import signal
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path

import psutil
import pytest

from course.content import open_course
from course.grading import trial
from course.isolation import Level
from course.isolation.levels import obstacle_to
from course.model.result import Verdict
from tests.batch.command import Command, graded, half_written, verdicts
from tests.batch.conftest import Lay
from tests.conftest import FIXTURES
from tests.processes import words_of

pytest.importorskip("distributed")
pytestmark = pytest.mark.slow

PEOPLE = [f"s{n:03}" for n in range(60)]
PATIENCE = 60.0
ON_TWO = ("--cluster", "local")


@pytest.fixture
def quiz(lay: Lay, tmp_path: Path) -> Command:
    """A class whose gradings take no time, because the test is about how tasks are sent."""
    folder = lay(*PEOPLE)
    course = ("--course", str(FIXTURES / "quiz_course"))
    return Command(folder, tmp_path / "grades", tmp_path / "tmp", (*ON_TWO, "--no-sandbox"), course)


@pytest.fixture
def start(quiz: Command) -> Iterator[Callable[[], subprocess.Popen[str]]]:
    started: list[subprocess.Popen[str]] = []

    def start() -> subprocess.Popen[str]:
        started.append(quiz.start())
        return started[-1]

    yield start
    for process in started:
        for member in members(process):
            member.kill()
        process.communicate()


def members(process: subprocess.Popen[str]) -> list[psutil.Process]:
    """Everything that runs in the command's session, which it leads."""
    return [each for each in psutil.process_iter() if _session(each) == process.pid]


def _session(process: psutil.Process) -> int | None:
    try:
        return None if process.status() == psutil.STATUS_ZOMBIE else os.getsid(process.pid)
    except (OSError, psutil.NoSuchProcess):
        return None


def dask_workers(process: subprocess.Popen[str]) -> list[psutil.Process]:
    children = psutil.Process(process.pid).children()
    return [child for child in children if any("spawn_main" in word for word in words_of(child))]


def test_one_of_two_workers_is_killed(quiz: Command, start: Callable[[], subprocess.Popen[str]]) -> None:
    process = start()
    found = graded(process, 5, 60)
    workers = dask_workers(process)
    assert len(workers) >= 1
    workers[0].kill()
    found += graded(process, 100, 60)
    assert process.wait(PATIENCE) == 0
    assert sorted(found) == PEOPLE
    assert {person for person, _ in verdicts(quiz.out)} == {*PEOPLE}
    assert {verdict for verdict, _ in verdicts(quiz.out).values()} == {Verdict.PASSED}
    assert list(half_written(quiz.out)) == []


def test_killed_and_stopped_it_leaves_nothing_and_goes_on(
    quiz: Command, start: Callable[[], subprocess.Popen[str]]
) -> None:
    first = start()
    graded(first, 5, 60)
    everybody = members(first)
    first.kill()
    assert psutil.wait_procs(everybody, PATIENCE)[1] == []
    found = [person for person, _ in verdicts(quiz.out)]  # it may have been killed before it said so
    assert len(found) >= 5
    second = start()
    found += graded(second, 5, 60)
    os.killpg(second.pid, signal.SIGINT)
    found += graded(second, 100, 60)
    assert second.wait(PATIENCE) == 130
    assert psutil.wait_procs(members(second), PATIENCE)[1] == []
    third = start()
    found += graded(third, 100, 60)
    assert third.wait(PATIENCE) == 0
    assert {*found} == {*PEOPLE}
    assert len(verdicts(quiz.out)) == 60
    assert list(quiz.temporary.glob("dask-scratch-space/*/grading-*")) == []


def test_programs_run_there_as_they_do_here(tmp_path: Path) -> None:
    obstacle = obstacle_to(Level.CONTAINED)
    if obstacle:
        pytest.skip(f"not exercised here: {obstacle}")
    course = open_course()
    exercise = course.exercise("02-script")
    for name in ("right", "wrong"):
        (tmp_path / "class" / name).mkdir(parents=True)
        trial.lay_solution(course, exercise, tmp_path / "class" / name)
    trial.apply_mistake(exercise, exercise.mistakes()[0], tmp_path / "class" / "wrong")
    words = ("--exercises", "02-script")
    here = Command(tmp_path / "class", tmp_path / "here", tmp_path / "tmp", words)
    there = Command(tmp_path / "class", tmp_path / "there", tmp_path / "tmp", (*words, *ON_TWO))
    assert here.run()[0] == there.run()[0] == 0
    assert verdicts(there.out) == verdicts(here.out)
    assert (there.out / "evidence" / "right" / "02-script.mcap").stat().st_size > 1000
